// All figures as CSV, made in the page: meters, then each grid with its points.

import { gridPoint, grids, maintenance, meters, scene } from '../desk';

const cell = (value: unknown): string => {
    const text = value === null || value === undefined ? '' : String(value);
    return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
};

export function csv(): string {
    const kept = maintenance.peek();
    const lines: unknown[][] = [['scene', scene.peek()?.name ?? ''], ['maintenance factor', kept], []];
    lines.push(['meter', 'kind', 'x [m]', 'y [m]', 'z [m]', 'lux', '± (95 %)']);
    for (const [, m] of meters.all()) {
        lines.push([m.name, m.kind, ...m.point, m.lux && m.lux[0] * kept, m.lux && m.lux[1] * kept]);
    }
    for (const [, g] of grids.all()) {
        lines.push([], ['grid', g.name], ['points', g.columns * g.rows]);
        const figures = { mean: g.mean, min: g.min, max: g.max };
        for (const [name, value] of Object.entries(figures)) lines.push([name, value == null ? null : value * kept]);
        lines.push(['uniformity', g.uniformity], ['x [m]', 'y [m]', 'z [m]', 'lux']);
        (g.lux ?? []).forEach((lux, k) => {
            const point = gridPoint(g, k % g.columns, Math.floor(k / g.columns));
            lines.push([...point.map((v) => v.toFixed(3)), lux === null ? null : lux * kept]);
        });
    }
    return lines.map((line) => line.map(cell).join(',')).join('\r\n') + '\r\n';
}

export function saveFile(name: string, url: string): void {
    const link = document.createElement('a');
    link.href = url;
    link.download = name;
    document.body.append(link);
    link.click();
    link.remove();
}

export function saveCsv(): void {
    const url = URL.createObjectURL(new Blob([csv()], { type: 'text/csv' }));
    saveFile(`${scene.peek()?.name ?? 'figures'}.csv`, url);
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
