// src/later/compare.tsx
import { before as Vt, comparing as Pt, digits as Lt, fitted as St, useEffect as kt, useRef as Ct, viewSize as At, wipeAt as nt } from "./desk.js";
import { Fragment as Ft, jsx as ot, jsxs as Gt } from "./desk.js";
function Tt() {
  const t = Pt.value;
  const n = Vt.value;
  const a = Ct(null);
  kt(() => {
    const f = a.current;
    if (!f || !n) return;
    f.width = n.picture.width;
    f.height = n.picture.height;
    f.getContext("2d", { alpha: false })?.drawImage(n.picture, 0, 0);
  }, [n, t]);
  if (!t || !n) return null;
  const [u] = At.value;
  const c = nt.value;
  const p = St(n.picture.width, n.picture.height);
  const h = Math.max(0, Math.min(1, (c * u - p.x) / (n.picture.width * p.scale)));
  const b = (f) => {
    const s = f.currentTarget;
    f.stopPropagation();
    if (f.type === "pointerdown") s.setPointerCapture(f.pointerId);
    else if (s.hasPointerCapture(f.pointerId)) {
      const l = s.parentElement.getBoundingClientRect();
      nt.value = Math.max(0, Math.min(1, (f.clientX - l.left) / l.width));
    }
  };
  const E = (f) => {
    const s = { ArrowLeft: -0.02, ArrowRight: 0.02 }[f.key];
    if (!s) return;
    f.stopPropagation();
    f.preventDefault();
    nt.value = Math.max(0, Math.min(1, c + s));
  };
  return /* @__PURE__ */ Gt(Ft, { children: [
    /* @__PURE__ */ ot(
      "canvas",
      {
        ref: a,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: t === "wipe" ? `inset(0 ${100 - 100 * h}% 0 0)` : "none" }
      }
    ),
    /* @__PURE__ */ ot("span", { class: "tag left", children: "before" }),
    t === "wipe" && /* @__PURE__ */ ot(
      "div",
      {
        class: "wipe",
        "data-handle": "wipe",
        role: "slider",
        tabIndex: 0,
        "aria-label": "Wipe between before and now",
        "aria-valuemin": 0,
        "aria-valuemax": 100,
        "aria-valuenow": Math.round(c * 100),
        "aria-valuetext": `${Lt(c * 100)} % before`,
        style: { left: `${100 * c}%` },
        onPointerDown: b,
        onPointerMove: b,
        onKeyDown: E
      }
    )
  ] });
}

// src/later/handles.tsx
import {
  chosenLamps as gt,
  computed as vt,
  editor as Nt,
  effect as Wt,
  fitted as Ut,
  Gesture as Xt,
  handles as Yt,
  lamps as B,
  lookOnly as Bt,
  pinhole as jt,
  placed as Qt,
  positions as Zt,
  role as Jt,
  selection as ft,
  shown as te,
  titleOf as ee,
  tool as ne,
  useEffect as oe,
  useRef as re,
  viewSize as ie
} from "./desk.js";

// src/later/gizmo.ts
import { project as ut, ray as It } from "./desk.js";
import { across as Ht, add as S, cross as Dt, distance as Rt, dot as T, length as Kt, normal as X, scale as k, sub as K, turn as qt } from "./desk.js";
var zt = "http://www.w3.org/2000/svg";
var rt = 84;
var H = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
var Y = ["x", "y", "z"];
var pt = 0.1;
var Ot = 5 * Math.PI / 180;
var dt = 48;
function ht(t, n) {
  const a = (e, o, r) => {
    const i = document.createElementNS(zt, e);
    i.setAttribute("class", r);
    o.append(i);
    return i;
  };
  const u = (e, o, r) => {
    const i = a("g", t, `handle ${e} ${Y[o] ?? ""}`);
    i.setAttribute("data-handle", r);
    return { group: i, hit: a("path", i, "hit"), seen: a("path", i, "seen") };
  };
  const c = a("path", t, "aim-line");
  const p = H.map((e, o) => u("ring", o, `ring-${Y[o]}`));
  const h = H.map((e, o) => u("plane", o, `plane-${Y[o]}`));
  const b = H.map((e, o) => u("arrow", o, `move-${Y[o]}`));
  const E = u("centre", -1, "move-view");
  const f = u("aim", -1, "aim");
  const s = a("text", t, "handle-text");
  const l = (e, o) => {
    const [r, i, m] = ut(e.hole, o);
    if (m < 0.02 && !e.hole.parallel) return null;
    return [e.fit.x + r * e.fit.scale, e.fit.y + i * e.fit.scale];
  };
  const x = (e, o) => {
    const r = ut(e.hole, o)[2];
    return rt / e.fit.scale * e.hole.pixel * (e.hole.parallel ? 1 : Math.max(r, 0.02));
  };
  const R = (e, o, r = false) => {
    const i = o.filter((d) => d !== null);
    const m = i.length < o.length || i.length < 2 ? "" : `M${i.map((d) => `${d[0].toFixed(1)} ${d[1].toFixed(1)}`).join("L")}${r ? "Z" : ""}`;
    e.setAttribute("d", m);
  };
  const Q = (e, o, r) => {
    e.setAttribute("d", o ? `M${o[0] - r} ${o[1]}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0` : "");
  };
  const Z = (e, o) => e.forEach((r) => r.group.classList.toggle("gone", !o));
  function Et(e, o) {
    const r = e.position;
    const i = l(o, r);
    const m = x(o, r);
    const d = e.mode === "move";
    Z([...b, ...h, E], d && i !== null);
    Z(p, !d && i !== null && e.direction !== null);
    const $ = e.aim ?? (e.direction ? S(r, k(e.direction, 3 * m)) : null);
    Z([f], $ !== null && i !== null);
    if (!i) {
      c.setAttribute("d", "");
      return;
    }
    H.forEach((M, w) => {
      const v = l(o, S(r, k(M, m)));
      const G = v ? Math.hypot(v[0] - i[0], v[1] - i[1]) < 12 : true;
      b[w].group.classList.toggle("gone", !d || G);
      if (v && d) {
        const [I, _] = [(v[0] - i[0]) / rt, (v[1] - i[1]) / rt];
        const U = Math.hypot(I, _) || 1;
        const [A, N] = [I / U, _ / U];
        const et = [i[0] + 14 * A, i[1] + 14 * N];
        R(b[w].hit, [et, v]);
        b[w].seen.setAttribute("d", `M${et[0].toFixed(1)} ${et[1].toFixed(1)}L${v[0].toFixed(1)} ${v[1].toFixed(1)}M${(v[0] - 9 * A - 4.5 * N).toFixed(1)} ${(v[1] - 9 * N + 4.5 * A).toFixed(1)}L${v[0].toFixed(1)} ${v[1].toFixed(1)}L${(v[0] - 9 * A + 4.5 * N).toFixed(1)} ${(v[1] - 9 * N - 4.5 * A).toFixed(1)}`);
      }
      const [z, O] = [H[(w + 1) % 3], H[(w + 2) % 3]];
      const P = Math.abs(T(M, o.hole.parallel ? o.hole.forward : X(K(r, o.hole.eye)))) < 0.15;
      h[w].group.classList.toggle("gone", !d || P);
      const W = (I, _) => l(o, S(r, S(k(z, I * m), k(O, _ * m))));
      const ct = [W(0.3, 0.3), W(0.5, 0.3), W(0.5, 0.5), W(0.3, 0.5)];
      R(h[w].hit, ct, true);
      R(h[w].seen, ct, true);
      if (!d) {
        const I = Array.from({ length: dt + 1 }, (_, U) => {
          const A = 2 * Math.PI * U / dt;
          return l(o, S(r, S(k(z, Math.cos(A) * m), k(O, Math.sin(A) * m))));
        });
        R(p[w].hit, I);
        R(p[w].seen, I);
      }
    });
    Q(E.hit, i, 13);
    Q(E.seen, i, 7);
    const g = $ && l(o, $);
    R(c, [i, g]);
    Q(f.hit, g, 16);
    f.seen.setAttribute("d", g ? `M${g[0] - 8} ${g[1]}h16M${g[0]} ${g[1] - 8}v16M${g[0] - 5} ${g[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  const $t = n.effect(() => {
    const e = n.target.value;
    const o = n.view.value;
    t.classList.toggle("empty", !e || !o);
    if (e && o) Et(e, o);
  });
  const lt = (e, o, r) => It(e.hole, (o.clientX - r.left - e.fit.x) / e.fit.scale, (o.clientY - r.top - e.fit.y) / e.fit.scale);
  function q(e, o, r) {
    e.addEventListener("pointerdown", (i) => {
      if (i.button !== 0) return;
      i.preventDefault();
      i.stopPropagation();
      const m = n.view.peek();
      if (!m || !n.target.peek()) return;
      const d = t.getBoundingClientRect();
      const $ = r(m);
      const g = n.hold(o);
      const M = lt(m, i, d);
      $(M, false, { ...g, move: () => {
      }, turn: () => {
      } });
      e.setPointerCapture(i.pointerId);
      e.classList.add("held");
      const w = (P) => {
        s.textContent = $(lt(m, P, d), P.ctrlKey || P.metaKey, g);
        s.setAttribute("x", String(P.clientX - d.left + 16));
        s.setAttribute("y", String(P.clientY - d.top - 12));
      };
      const v = (P) => {
        e.removeEventListener("pointermove", w);
        e.removeEventListener("pointerup", G);
        e.removeEventListener("pointercancel", z);
        removeEventListener("keydown", O, true);
        e.classList.remove("held");
        s.textContent = "";
        if (P) g.end();
        else g.cancel();
      };
      const G = () => v(true);
      const z = () => v(false);
      const O = (P) => {
        if (P.key !== "Escape") return;
        P.stopPropagation();
        v(false);
      };
      e.addEventListener("pointermove", w);
      e.addEventListener("pointerup", G);
      e.addEventListener("pointercancel", z);
      addEventListener("keydown", O, true);
    });
  }
  const J = (e, o, r) => r ? Math.round(e / o) * o : e;
  const tt = (e) => e.map((o) => o.toFixed(2)).join("  ") + " m";
  H.forEach((e, o) => {
    q(b[o].group, "move", () => {
      const r = n.target.peek().position;
      let i = null;
      return (m, d, $) => {
        const g = _t(r, e, m);
        i ??= g;
        const M = k(e, J(g - i, pt, d));
        $.move(M);
        return tt(M);
      };
    });
    q(h[o].group, "move", () => at(e));
    q(p[o].group, "turn", () => {
      const r = n.target.peek();
      const i = r.direction;
      const m = { at: null };
      return (d, $, g) => {
        const M = mt(r.position, e, d);
        const w = M && X(K(M, r.position), Ht(e));
        if (!w) return "";
        m.at ??= w;
        const v = Math.atan2(T(e, Dt(m.at, w)), T(m.at, w));
        const G = J(v, Ot, $);
        g.turn(X(qt(i, e, G)), null);
        return `${(G * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  });
  q(E.group, "move", (e) => at(e.hole.forward));
  q(f.group, "aim", (e) => {
    const o = n.target.peek();
    const r = o.aim ?? S(o.position, k(o.direction, 3 * x(e, o.position)));
    const i = st(r, e.hole.forward);
    return (m, d, $) => {
      const g = i(m, d);
      const M = S(r, g);
      if (Rt(M, o.position) > 1e-3) $.turn(X(K(M, o.position)), M);
      return tt(M);
    };
  });
  function at(e) {
    const o = st(n.target.peek().position, e);
    return (r, i, m) => {
      const d = o(r, i);
      m.move(d);
      return tt(d);
    };
  }
  function st(e, o) {
    let r = null;
    return (i, m) => {
      const d = mt(e, o, i);
      if (!d) return [0, 0, 0];
      r ??= d;
      return K(d, r).map(($) => J($, pt, m));
    };
  }
  return { stop: $t };
}
function _t(t, n, a) {
  const u = K(t, a.origin);
  const c = T(n, a.direction);
  const p = 1 - c * c;
  if (p < 1e-6) return 0;
  return (c * T(a.direction, u) - T(n, u)) / p;
}
function mt(t, n, a) {
  const u = T(n, a.direction);
  if (Math.abs(u) < 1e-4 * Kt(n)) return null;
  const c = T(K(t, a.origin), n) / u;
  if (c < 0 || c > 1e3) return null;
  return S(a.origin, k(a.direction, c));
}

// src/later/handles.tsx
import { jsx as pe } from "./desk.js";
var le = vt(() => {
  if (ft.value?.kind !== "lamp" && ft.value?.kind !== "group") return null;
  if (Bt.value || Jt.value === "watch" || !Nt.value.you || ne.value === "aim") return null;
  const t = gt.value.filter((a) => B.get(a)?.place?.position);
  if (!t.length) return null;
  const n = B.get(t[t.length - 1])?.place;
  if (!n?.position) return null;
  return {
    position: n.position,
    direction: n.direction ?? null,
    aim: n.aim ?? null,
    mode: Yt.value
  };
});
var ae = vt(() => {
  const t = te.value;
  void ie.value;
  if (!t) return null;
  const { width: n, height: a } = t.head;
  return { hole: jt(t.camera, n, a), fit: Ut(n, a) };
});
var se = () => gt.peek().filter((t) => B.entry(t)?.shown.peek().place?.position);
var ce = {
  effect: Wt,
  target: le,
  view: ae,
  hold(t) {
    const n = se();
    const a = t === "move" ? "Move" : t === "aim" ? "Aim" : "Turn";
    const u = new Xt(`${a} ${ee(n)}`);
    const c = Zt(n);
    return {
      move: (p) => u.set(Qt(n, p, c)),
      turn: (p, h) => {
        const b = Object.fromEntries(
          n.filter((E) => B.entry(E)?.shown.peek().place?.direction).map((E) => [E, { place: { direction: p, aim: h } }])
        );
        u.set({ lamps: b });
      },
      end: () => u.end(),
      cancel: () => u.cancel()
    };
  }
};
function ue() {
  const t = re(null);
  oe(() => ht(t.current, ce).stop, []);
  return /* @__PURE__ */ pe("svg", { id: "handles", ref: t, "aria-hidden": "true" });
}

// src/later/inspector.tsx
function de() {
  return null;
}

// src/later/legend.tsx
import { candles as me, display as he, Field as fe, show as ge, three as bt, useRef as ve } from "./desk.js";
import { jsx as V, jsxs as j } from "./desk.js";
var it = [1, 2, 5];
function be(t, n, a) {
  const u = [];
  if (a === "linear") {
    const c = (n - t) / 5;
    const p = 10 ** Math.floor(Math.log10(c));
    const h = p * (it.find((b) => b * p >= c) ?? 10);
    for (let b = Math.ceil(t / h) * h; b <= n * 1.0001; b += h) u.push(b);
    return u;
  }
  for (let c = Math.floor(Math.log10(t)); c <= Math.ceil(Math.log10(n)); c++) {
    for (const p of it) {
      const h = p * 10 ** c;
      if (h >= t * 0.999 && h <= n * 1.001) u.push(h);
    }
  }
  return u.length > 10 ? u.filter((c) => Math.abs(Math.log10(c) % 1) < 1e-6) : u;
}
function we(t, n) {
  if (n.scale === "linear") return (t - n.low) / (n.high - n.low);
  return Math.log(t / n.low) / Math.log(n.high / n.low);
}
var C = (t, n) => {
  const a = { ...t, ...n };
  if (a.scale === "log") a.low = Math.max(a.low, 1e-3);
  if (a.high > a.low * 1.01) ge({ false_color: a });
};
function wt(t, n) {
  const a = Math.round(Math.log10(t) * 3) + n;
  const u = (a % 3 + 3) % 3;
  return it[u] * 10 ** ((a - u) / 3);
}
function ye() {
  const t = he.value.false_color;
  const n = ve(null);
  if (!t) return null;
  const a = me.value === "fc";
  const u = t.quantity === "illuminance";
  const c = u ? a ? "fc" : "lx" : a ? "fL" : "cd/m²";
  const p = a ? u ? 1 / 10.7639 : 0.2919 : 1;
  const h = t.colors;
  const b = h?.length ? `linear-gradient(to top, ${h.join(", ")})` : void 0;
  const E = (s) => ({
    onPointerDown: (l) => {
      l.currentTarget.setPointerCapture(l.pointerId);
      n.current = { y: l.clientY, end: s, from: t[s] };
    },
    onPointerMove: (l) => {
      const x = n.current;
      if (x?.end === s) C(t, { [s]: wt(x.from, Math.round((x.y - l.clientY) / 14)) });
    },
    onPointerUp: () => n.current = null,
    onPointerCancel: () => n.current = null,
    onKeyDown: (l) => {
      const x = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[l.key];
      if (!x) return;
      l.preventDefault();
      l.stopPropagation();
      C(t, { [s]: wt(t[s], x) });
    }
  });
  const f = ({ end: s }) => /* @__PURE__ */ j("div", { class: "end", children: [
    /* @__PURE__ */ V(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": s === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": t[s],
        "aria-valuemin": 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${bt(t[s] * p)} ${c}`,
        ...E(s)
      }
    ),
    /* @__PURE__ */ V(
      fe,
      {
        label: s === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((t[s] * p).toPrecision(3)),
        set: (l) => C(t, { [s]: l(t[s] * p) / p })
      }
    )
  ] });
  return /* @__PURE__ */ j("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": true, children: [
    /* @__PURE__ */ j("header", { children: [
      /* @__PURE__ */ V(
        "button",
        {
          "aria-label": `Quantity: ${u ? "illuminance" : "luminance"}`,
          onClick: () => C(t, { quantity: u ? "luminance" : "illuminance" }),
          children: c
        }
      ),
      /* @__PURE__ */ V("button", { "aria-pressed": t.scale === "log", onClick: () => C(t, { scale: t.scale === "log" ? "linear" : "log" }), children: "log" }),
      /* @__PURE__ */ V("button", { "aria-pressed": t.lines, onClick: () => C(t, { lines: !t.lines }), children: "lines" })
    ] }),
    /* @__PURE__ */ V(f, { end: "high" }),
    /* @__PURE__ */ V("div", { class: "scale", style: { background: b }, children: be(t.low, t.high, t.scale).map((s) => /* @__PURE__ */ V("span", { style: { bottom: `${100 * we(s, t)}%` }, children: bt(s * p) }, s)) }),
    /* @__PURE__ */ V(f, { end: "low" }),
    /* @__PURE__ */ j("footer", { children: [
      /* @__PURE__ */ V("button", { onClick: () => C(t, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      /* @__PURE__ */ V("button", { onClick: () => C(t, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      /* @__PURE__ */ V(
        "select",
        {
          "aria-label": "Palette",
          value: t.palette,
          onChange: (s) => C(t, { palette: s.currentTarget.value }),
          children: t.palettes?.map((s) => /* @__PURE__ */ V("option", { children: s }, s)) ?? /* @__PURE__ */ V("option", { children: t.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
function xe() {
  return null;
}

// src/later/what.tsx
import {
  addMeter as Me,
  aim as Ee,
  chosenLamps as yt,
  closeWhat as xt,
  digits as $e,
  hovered as Mt,
  Icon as Ve,
  luxText as F,
  nameOf as Pe,
  select as Le,
  useEffect as Se,
  useRef as ke,
  viewSize as Ce,
  what as Ae
} from "./desk.js";
import { jsx as y, jsxs as L } from "./desk.js";
var D = (t) => t.direct[0] + t.indirect[0] + t.caustic[0];
var Te = (t) => Math.hypot(t.direct[1], t.indirect[1], t.caustic[1]);
function Fe() {
  const t = Ae.value;
  const n = ke(null);
  Se(() => {
    if (t && n.current && !n.current.contains(document.activeElement)) n.current.focus();
  }, [t?.x, t?.y]);
  if (!t) return null;
  const [a, u] = Ce.value;
  const c = [...t.lamps].sort((l, x) => D(x) - D(l));
  const p = c.reduce((l, x) => l + D(x), 0) || 1;
  const h = c.slice(0, 9);
  const b = p - h.reduce((l, x) => l + D(x), 0);
  const E = Math.max(8, Math.min(t.x + 12, a - 332));
  const f = Math.max(8, Math.min(t.y + 12, u - 120 - 28 * Math.min(c.length, 10)));
  const s = t.lux ? `${F(t.lux[0])} ±${F(t.lux[1], false)}` : "Measuring…";
  return /* @__PURE__ */ L(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: n,
      style: { left: `${E}px`, top: `${f}px` },
      onKeyDown: (l) => {
        if (l.key !== "Escape") return;
        l.stopPropagation();
        xt();
        document.getElementById("view")?.focus();
      },
      "data-scroll": true,
      children: [
        /* @__PURE__ */ L("header", { children: [
          /* @__PURE__ */ y("strong", { class: t.done ? "" : "unsettled", children: s }),
          /* @__PURE__ */ y("span", { class: "quiet", children: "what lights this" }),
          /* @__PURE__ */ y("button", { class: "icon", "aria-label": "Close", onClick: xt, children: /* @__PURE__ */ y(Ve, { name: "close" }) })
        ] }),
        /* @__PURE__ */ L("ol", { children: [
          h.map((l) => /* @__PURE__ */ y(
            "li",
            {
              onPointerEnter: () => Mt.value = { kind: "lamp", id: l.id },
              onPointerLeave: () => Mt.value = null,
              children: /* @__PURE__ */ L("button", { class: "row", onClick: () => Le("lamp", l.id), children: [
                /* @__PURE__ */ y("span", { class: "name", children: Pe("lamp", l.id) }),
                /* @__PURE__ */ L("span", { class: "figure", children: [
                  $e(100 * D(l) / p, D(l) / p < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                /* @__PURE__ */ L("span", { class: "figure lux", children: [
                  F(D(l)),
                  " ±",
                  F(Te(l), false)
                ] }),
                /* @__PURE__ */ L("span", { class: "bar", "aria-hidden": "true", children: [
                  /* @__PURE__ */ y("i", { class: "direct", style: { width: `${100 * l.direct[0] / p}%` } }),
                  /* @__PURE__ */ y("i", { class: "indirect", style: { width: `${100 * l.indirect[0] / p}%` } }),
                  /* @__PURE__ */ y("i", { class: "caustic", style: { width: `${100 * l.caustic[0] / p}%` } })
                ] }),
                /* @__PURE__ */ L("span", { class: "spoken", children: [
                  "direct ",
                  F(l.direct[0]),
                  ", indirect ",
                  F(l.indirect[0]),
                  ", caustic",
                  " ",
                  F(l.caustic[0])
                ] })
              ] })
            },
            l.id
          )),
          c.length > h.length && /* @__PURE__ */ L("li", { class: "quiet", children: [
            "and ",
            c.length - h.length,
            " others, ",
            F(b),
            " together"
          ] }),
          !c.length && /* @__PURE__ */ y("li", { class: "quiet", children: t.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        /* @__PURE__ */ L("footer", { children: [
          /* @__PURE__ */ y("span", { class: "key direct", children: "direct" }),
          /* @__PURE__ */ y("span", { class: "key indirect", children: "indirect" }),
          /* @__PURE__ */ y("span", { class: "key caustic", children: "caustic" }),
          /* @__PURE__ */ y("span", { class: "gap" }),
          yt.value.length > 0 && /* @__PURE__ */ y("button", { onClick: () => Ee(yt.peek(), t.hit.point), children: "Aim here" }),
          /* @__PURE__ */ y("button", { onClick: () => Me(t.hit.point, t.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Tt as Compare,
  ue as Gizmo,
  de as Inspector,
  ye as Legend,
  xe as Sheets,
  Fe as What
};
