//! The page of a report: HTML that is well-formed XML too, with its own style and without a script.

use crate::findings::{Comparison, Demand, Table, digits};
use crate::record::{Record, Shown, ShownImage};

const STYLE: &str = include_str!("page.css");

/// The whole page.
pub(crate) fn html(records: &[Record]) -> String {
    let contents: String = records.iter().map(entry).collect();
    let sections: String = records.iter().map(section).collect();
    let verdicts = || records.iter().flat_map(|r| &r.comparisons).filter_map(Comparison::held);
    let (held, all) = (verdicts().filter(|held| *held).count(), verdicts().count());
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <title>Lampyris: the laboratory</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header><h1>The laboratory</h1>\n<p>What the papers say, and what Lampyris measures. Experiments: {}. Figures \
         that we ask something of: {all}, of which {held} are as asked and {} are missed. All figures are in <a href=\"figures.json\">\
         figures.json</a>.</p></header>\n<nav><ul>\n{contents}</ul></nav>\n<main>\n{sections}</main>\n</body>\n</html>\n",
        records.len(),
        all - held,
    )
}

/// A line of the contents.
fn entry(record: &Record) -> String {
    let missed = record.comparisons.iter().filter(|c| c.held() == Some(false)).count();
    let missed = match missed {
        0 => String::new(),
        n => format!(" <span class=\"missed\">{n} missed</span>"),
    };
    let (name, title) = (&record.name, escape(&record.title));
    format!("<li><a href=\"#{name}\">{name}</a> {title}{missed}</li>\n")
}

fn section(record: &Record) -> String {
    let mut text = format!(
        "<section id=\"{}\">\n<h2>{}</h2>\n<p class=\"place\">{}, {}</p>\n<blockquote><p>{}</p></blockquote>\n",
        record.name,
        escape(&record.title),
        escape(&record.paper),
        escape(&record.place),
        prose(&record.claim)
    );
    if !record.comparisons.is_empty() {
        text += "<div class=\"wide\"><table>\n<thead><tr><th>figure</th><th>paper</th><th>ours</th><th>ratio</th>\
                 <th>asked</th><th>verdict</th></tr></thead>\n<tbody>\n";
        text.extend(record.comparisons.iter().map(comparison));
        text += "</tbody>\n</table></div>\n";
    }
    text.extend(record.exhibits.iter().map(|shown| exhibit(&record.name, shown)));
    if !record.gaps.is_empty() {
        let gaps: String = record.gaps.iter().map(|gap| format!("<li>{}</li>\n", prose(gap))).collect();
        text += &format!("<h3>Where the paper leaves a gap</h3>\n<ul>\n{gaps}</ul>\n");
    }
    text + &format!(
        "<p class=\"how\"><code>lampyris lab run {}{}</code>: {:.1} s with {} threads, version {}</p>\n</section>\n",
        record.name,
        if record.quick { " --quick" } else { "" },
        record.seconds,
        record.threads,
        escape(&record.version)
    )
}

fn comparison(c: &Comparison) -> String {
    let unit = if c.unit.is_empty() { String::new() } else { format!(" {}", c.unit) };
    let with_unit = |value: f64| escape(&format!("{}{unit}", digits(value)));
    let paper = match (c.paper, c.says.is_empty()) {
        (Some(value), true) => with_unit(value),
        (Some(value), false) => format!("{} ({})", with_unit(value), prose(&c.says)),
        (None, false) => prose(&c.says),
        (None, true) => "–".into(),
    };
    let asked = match c.demand {
        None => String::new(),
        Some(Demand::AtLeast(least)) => format!("≥ {}", digits(least)),
        Some(Demand::AtMost(most)) => format!("≤ {}", digits(most)),
        Some(Demand::Within(least, most)) => format!("{} to {}", digits(least), digits(most)),
    };
    let verdict = match c.held() {
        None => "",
        Some(true) => "<span class=\"held\">held</span>",
        Some(false) => "<span class=\"missed\">missed</span>",
    };
    let ratio = c.ratio().map(digits).unwrap_or_default();
    format!(
        "<tr><th scope=\"row\">{}</th><td>{paper}</td><td>{}</td><td>{ratio}</td><td>{asked}</td><td>{verdict}</td></tr>\n",
        prose(&c.what),
        with_unit(c.ours)
    )
}

fn exhibit(folder: &str, shown: &Shown) -> String {
    match shown {
        Shown::Note(text) => format!("<p>{}</p>\n", prose(text)),
        Shown::Table(table) => self::table(table),
        Shown::Plot { file, plot } => {
            let (width, height) = plot.size();
            let alt = escape(&format!("{}: {} over {}", plot.title, plot.y.label, plot.x.label));
            let class = if plot.square { "square" } else { "plot" };
            format!(
                "<figure class=\"{class}\"><img src=\"{folder}/{file}\" alt=\"{alt}\" width=\"{width}\" height=\"{height}\"/></figure>\n"
            )
        }
        Shown::Images(images) => {
            let figure = |image: &ShownImage| {
                let (file, [width, height]) = (&image.file, image.size);
                let (alt, caption) = (escape(&image.caption), prose(&image.caption));
                format!(
                    "<figure style=\"width: {width}px\"><img src=\"{folder}/{file}\" alt=\"{alt}\" width=\"{width}\" height=\"{height}\"/>\
                     <figcaption>{caption}</figcaption></figure>\n"
                )
            };
            let figures: String = images.iter().map(figure).collect();
            format!("<div class=\"gallery\">\n{figures}</div>\n")
        }
    }
}

fn table(table: &Table) -> String {
    let head: String = table.columns.iter().map(|c| format!("<th>{}</th>", prose(c))).collect();
    let row = |cells: &Vec<String>| {
        let cells: String = cells.iter().map(|c| format!("<td>{}</td>", prose(c))).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let rows: String = table.rows.iter().map(row).collect();
    let title = prose(&table.title);
    format!(
        "<div class=\"wide\"><table>\n<caption>{title}</caption>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n"
    )
}

/// Text of the page, in which what stands between backquotes is code.
fn prose(text: &str) -> String {
    let text = escape(text);
    if !text.matches('`').count().is_multiple_of(2) {
        return text;
    }
    let span = |(number, span): (usize, &str)| match number % 2 {
        0 => span.to_owned(),
        _ => format!("<code>{span}</code>"),
    };
    text.split('`').enumerate().map(span).collect()
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_is_marked_and_nothing_of_the_text_is_markup() {
        assert_eq!(
            prose("the part `caustic`, <b> & `a<b`"),
            "the part <code>caustic</code>, &lt;b&gt; &amp; <code>a&lt;b</code>"
        );
        assert_eq!(prose("one ` alone"), "one ` alone");
    }
}
