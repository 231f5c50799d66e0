// src/later/actions.ts
import {
  adding as Ui,
  asked as _i,
  ask as Xi,
  back as Yi,
  candles as to,
  chosenLamps as he,
  clearSolo as zi,
  command as $n,
  compareHeld as ji,
  copyText as Zi,
  DEFAULT_FALSE as Qi,
  deselect as Ji,
  each as Tn,
  edit as Pn,
  exposeBy as no,
  falseColor as es,
  fine as ao,
  forth as ts,
  frameSelection as ns,
  go as as,
  goHome as os,
  goInside as ls,
  goPreset as rs,
  hands as is,
  here as ss,
  highlight as us,
  history as oo,
  lampMarks as lo,
  lamps as At,
  listing as ro,
  lookOnly as io,
  looks as cs,
  maintenance as ps,
  panels as so,
  PRESETS as ms,
  register as ds,
  say as at,
  scene as hs,
  selection as fo,
  send as fs,
  sheet as tt,
  show as It,
  soloSelection as gs,
  spot as nt,
  startTool as Ce,
  stepSelection as uo,
  storeLook as bs,
  storeView as vs,
  theme as co,
  things as po,
  titleOf as go,
  toggleFalse as ys,
  toggleWipe as ks,
  travel as mo,
  views as ws,
  walking as Ln,
  whyNot as X
} from "./desk.js";

// src/later/differ.ts
var ft = (e) => ({
  quantity: "difference",
  against: e,
  low: -500,
  high: 500,
  scale: "linear",
  palette: "diverging",
  lines: !1
});
function fa(e) {
  let t = Math.min(1e6, Math.max(0.01, e.high));
  return { ...e, low: -t, high: t, scale: "linear" };
}

// src/later/legend.tsx
import { asked as jl, candles as Zl, DEFAULT_FALSE as Ql, display as Jl, Field as er, looks as tr, show as ba, three as nr, useRef as ar } from "./desk.js";
import { Fragment as ir, jsx as K, jsxs as me } from "./desk.js";
var va = { quantity: "clamped", low: 0, high: 50, scale: "linear", palette: "even", lines: !1 }, gn = [1, 2, 5];
function or(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, l = 10 ** Math.floor(Math.log10(o)), r = l * (gn.find((s) => s * l >= o) ?? 10);
    for (let s = Math.ceil(e / r) * r; s <= t * 1.0001; s += r) a.push(s);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let l of gn) {
      let r = l * 10 ** o;
      r >= e * 0.999 && r <= t * 1.001 && a.push(r);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function lr(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var te = (e, t) => {
  let n = jl({ ...e, ...t });
  n.against != null && (n = fa(n)), n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && ba({ false_color: n });
};
function ga(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return gn[a] * 10 ** ((n - a) / 3);
}
function rr() {
  let e = Jl.value.false_color, t = ar(null);
  if (!e) return null;
  let n = Zl.value === "fc", a = e.quantity === "difference", o = e.quantity === "clamped", l = e.quantity !== "luminance", r = o ? "%" : l ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", s = n && !o ? l ? 1 / 10.7639 : 0.2919 : 1, c = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, i = e.ticks ?? or(e.low, e.high, e.scale).map((m) => [m, lr(m, e)]), p = (m) => {
    let f = String(Number(m.toPrecision(2)));
    return a ? f.replace("-", "−").replace(/^(?=[1-9]|0\.)/, "+") : f;
  }, u = (m, f, S) => a ? { high: ga(Math.abs(f), m === "low" ? -S : S) } : { [m]: ga(f, S) }, b = (m) => ({
    onPointerDown: (f) => {
      f.currentTarget.setPointerCapture(f.pointerId), t.current = { y: f.clientY, end: m, from: e[m] };
    },
    onPointerMove: (f) => {
      let S = t.current;
      S?.end === m && te(e, u(m, S.from, Math.round((S.y - f.clientY) / 14)));
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (f) => {
      let S = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[f.key];
      S && (f.preventDefault(), f.stopPropagation(), te(e, u(m, e[m], S)));
    }
  }), d = ({ end: m }) => me("div", { class: "end", children: [
    o && m === "low" ? null : K(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": m === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[m],
        "aria-valuemin": a ? -1e6 : 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${nr(e[m] * s)} ${r}`,
        ...b(m)
      }
    ),
    (a || o) && m === "low" ? K("output", { children: p(e.low * s) }) : K(
      er,
      {
        label: m === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[m] * s).toPrecision(3)),
        set: (f) => te(e, { [m]: f(e[m] * s) / s })
      }
    )
  ] });
  return me("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    me("header", { children: [
      K(
        "button",
        {
          "aria-label": `${r}: ${a ? "difference" : e.quantity}, change`,
          onClick: () => a || o ? ba({ false_color: Ql }) : te(e, { quantity: l ? "luminance" : "illuminance" }),
          children: a ? `Δ ${r}` : r
        }
      ),
      !a && !o && K("button", { "aria-pressed": e.scale === "log", onClick: () => te(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      K("button", { "aria-pressed": e.lines, onClick: () => te(e, { lines: !e.lines }), children: "lines" })
    ] }),
    o && K("p", { class: "quiet", title: "What clamping takes from virtual lights close by, of all that comes to the eye. The picture has it: short rays pay it back. While something moves, pictures lack it.", children: "clamped" }),
    a && me("p", { class: "quiet", title: e.exact === !1 ? "Lamps that differ in the look share a layer of light: what is shown of them is their mean." : void 0, children: [
      e.exact === !1 ? "≈ " : "",
      "now − ",
      tr.get(e.against)?.name ?? "look"
    ] }),
    K(d, { end: "high" }),
    K("div", { class: "scale", style: { background: c }, children: i.map(([m, f]) => K("span", { style: { bottom: `${100 * f}%` }, children: p(m * s) }, m)) }),
    K(d, { end: "low" }),
    me("footer", { children: [
      a ? [50, 500].map((m) => me("button", { onClick: () => te(e, { high: m }), children: [
        "±",
        m
      ] }, m)) : o ? [10, 50].map((m) => me("button", { onClick: () => te(e, { low: 0, high: m }), children: [
        "0–",
        m
      ] }, m)) : me(ir, { children: [
        K("button", { onClick: () => te(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
        K("button", { onClick: () => te(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" })
      ] }),
      K(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (m) => te(e, { palette: m.currentTarget.value }),
          children: e.palettes?.map((m) => K("option", { children: m }, m)) ?? K("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/grouping.ts
import { chosenLamps as et, groups as St, lamps as qr, selection as Ct, step as Va, titleOf as Ia } from "./desk.js";

// src/later/tools.ts
import {
  add as yt,
  adding as yr,
  chosenLamps as Ma,
  distance as kr,
  dot as wr,
  edit as kt,
  effect as xr,
  free as La,
  grids as Sa,
  lamps as Ve,
  meters as Ca,
  normal as Ta,
  onTool as Mr,
  positionOf as Sr,
  say as wt,
  scale as vt,
  select as Cr,
  step as kn,
  sub as wn,
  titleOf as xt,
  tool as we,
  untracked as $r,
  up as Pa,
  workPlane as Lr
} from "./desk.js";

// src/later/area.ts
import { ask as sr, camera as ur, cross as cr, dot as ke, effect as ya, add as bn, normal as pr, scale as Ee, scene as ka, selection as mr, signal as dr, sub as hr, tool as fr } from "./desk.js";
var gr = 0.5, br = 0.3;
function vr(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
var gt = (e, t = 0) => e > 2 * t ? e - 2 * t : e;
function yn(e) {
  let [t, n] = [Math.min(...e), Math.max(...e)], a = n >= 2 * t ? t : n, o = a / Math.max(1, Math.round(a / vr(a)));
  return e.map((l) => Math.max(1, Math.round(l / o)));
}
function wa(e, t, n, a, o) {
  let l = Math.abs(n[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], r = pr(cr(n, l)), s = hr(t.point, e.point), [c, i] = [ke(s, l), ke(s, r)];
  if (Math.abs(c) < 0.05 || Math.abs(i) < 0.05) return null;
  let p = (ee) => ke(ee, n) - a, u = [e, t].every((ee) => ke(ee.normal, n) > 0.7 && p(ee.point) > br), b = u ? 0 : gr, d = u ? 0 : o - p(e.point), m = bn(bn(e.point, Ee(n, d)), bn(Ee(l, Math.min(c, 0)), Ee(r, Math.min(i, 0)))), f = [Math.abs(c), Math.abs(i)], [S, H] = yn(f.map((ee) => gt(ee, b)));
  return { corner: m, u: Ee(l, f[0]), v: Ee(r, f[1]), normal: n, columns: S, rows: H, border: b };
}
var xa = dr(null);
function bt() {
  let e = ka.value;
  return xa.value ?? (e ? Math.min(ke(e.bounds[0], e.up), ke(e.bounds[1], e.up)) : 0);
}
var vn = null;
ya(() => {
  let e = ur.value;
  e && !e.height && (vn = e.eye);
});
ya(() => {
  let e = ka.value?.up;
  !e || !vn || fr.value !== "grid" && mr.value?.kind !== "grid" || sr("ray", { origin: vn, direction: Ee(e, -1) }, (t) => {
    t.hit && (xa.value = ke(t.point, e));
  });
});

// src/later/tools.ts
var Ye = null, Tr = 3e4, Pr = { lux: 500, uniformity: 0.6 };
xr(() => {
  we.value !== "grid" && (Ye = null);
});
function Er(e) {
  if (!e) return wt("There is nothing at that point.", "warn");
  switch (we.peek()) {
    case "aim":
      ze(Ma.peek(), e.point), we.value = null;
      break;
    case "place":
      Vr(Ma.peek(), e), we.value = null;
      break;
    case "meter":
      Ze(e.point, e.normal), we.value = null;
      break;
    case "grid":
      if (!Ye) {
        Ye = e;
        return;
      }
      Ir(Ye, e), Ye = null, we.value = null;
      break;
    case "add":
      Ar(yr.peek(), e), we.value = null;
      break;
  }
}
Mr(Er);
function ze(e, t) {
  let n = {};
  for (let a of e) {
    let o = Ve.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: Ta(wn(t, o.position)) } });
  }
  if (!Object.keys(n).length) return wt("What is selected shines into all directions: it cannot be aimed.", "warn");
  kt(`Aim ${xt(e)}`, { lamps: n });
}
function je(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let l = o.filter((r) => !n.has(r));
    l.length && (Cr(t, l[l.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), Tr);
}
function Vr(e, t) {
  let n = Je(e), a = n.get(e[e.length - 1]);
  if (!a) return wt("What is selected has no place.", "warn");
  let o = (Ve.get(e[e.length - 1])?.place?.radius ?? 0) + 0.02;
  kt(`Put ${xt(e)} on a surface`, Qe(e, wn(yt(t.point, vt(t.normal, o)), a), n));
}
function Ze(e, t) {
  let n = La(Ca);
  je(Ca, "meter"), kt("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function Ir(e, t) {
  let n = wa(e, t, Pa.peek(), $r(bt), Lr.peek());
  if (!n) return wt("An area needs two corners that lie apart.", "warn");
  let a = La(Sa);
  je(Sa, "grid"), kt("Lay a grid", { grids: { [a]: { name: `Area ${a + 1}`, ...n, target: Pr } } });
}
var $a = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function Ar(e, t) {
  let n = Pa.peek(), a = wr(t.normal, n), o = a > 0.7 ? yt(t.point, vt(n, 1.2)) : yt(t.point, vt(t.normal, 0.15)), l = a > 0.7 || a < -0.7 ? vt(n, -1) : t.normal, r = { position: o };
  e !== "point" && e !== "sphere" && (r.direction = l), e === "spot" && Object.assign(r, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (r.radius = 0.15), e === "sphere" && (r.radius = 0.08);
  let s = Ve.all().filter(([, c]) => c.own).length;
  je(Ve, "lamp"), kn(`Add ${$a[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${$a[e] ?? e} ${s + 1}`, kind: e, flux: 800, place: r }
  });
}
function Mt(e, t, n) {
  !e.length || t < 1 || kn(`Copy ${xt(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function Ea(e) {
  e.length && kn(`Remove ${xt(e)}`, { do: "remove", lamps: e });
}
function Qe(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = Ve.get(o)?.place, r = n.get(o);
    if (!r) continue;
    let s = yt(r, t), c = l?.aim && kr(l.aim, s) > 1e-6 ? { direction: Ta(wn(l.aim, s)) } : {};
    a[o] = { place: { position: s, ...c } };
  }
  return { lamps: a };
}
function Je(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = Ve.get(n), o = a && Sr(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/grouping.ts
var Aa = (e) => {
  let t = qr.get(e)?.group ?? null;
  return t !== null && (St.get(t)?.lamps.length ?? 0) > 1 ? t : null;
};
function $t() {
  return et.value.length < 2 ? "Select two lamps or more first." : Ct.value?.kind === "group" && Ct.value.ids.length === 1 ? "This is a group already." : null;
}
function qa() {
  let e = new Set(St.all().map(([, n]) => n.name)), t = 1;
  for (; e.has(`Group ${t}`); ) t++;
  je(St, "group"), Va(`Group ${Ia(et.peek())}`, { do: "group", lamps: et.peek(), name: `Group ${t}` });
}
function Lt() {
  return et.value.some((e) => Aa(e) !== null) ? null : "What is selected is in no group.";
}
function Ra() {
  let e = Ct.peek(), t = et.peek().filter((a) => Aa(a) !== null), n = e?.kind === "group" && e.ids.length === 1 ? St.get(e.ids[0]) : void 0;
  Va(n ? `Dissolve ${n.name}` : `Take ${Ia(t)} out`, { do: "group", lamps: t }), Ct.value = { kind: "lamp", ids: t };
}

// src/later/most.ts
import { signal as Rr } from "./desk.js";
var Ie = Rr(1);

// src/later/there.ts
import { add as Fr, dot as Fa, go as Hr, here as Nr, moved as Dr, scale as Gr, spot as Or, sub as Wr, up as Kr, walking as Br, EYE_HEIGHT as Ur } from "./desk.js";
var _r = 1.2;
function Xr(e, t, n) {
  let a = Wr(n.point, e.eye);
  return e.height || Fa(n.normal, t) < 0.9 || Fa(a, t) > -_r ? null : Dr(e, Fr(a, Gr(t, Ur)));
}
function Ha() {
  let [e, t] = [Nr(), Or.value];
  return e && t && Br.value === "walk" ? Xr(e, Kr.value, t) : null;
}
var Na = () => Ha() ? null : "Point at the floor first, walking.";
function Da() {
  let e = Ha();
  e && Hr(e, "there");
}

// src/later/typed.tsx
import { effect as Li, handles as Ti, keysFirst as Pi, role as Ei, say as Vi, scale as Ii, selection as Ai, signal as qi, tool as Ri, untracked as Fi } from "./desk.js";

// src/later/handles.tsx
import {
  add as Ua,
  chosenLamps as ni,
  computed as Sn,
  editor as ai,
  effect as oi,
  fitted as li,
  Gesture as ri,
  handles as ii,
  lamps as Pt,
  lookOnly as si,
  middle as ui,
  nameOf as ci,
  normal as pi,
  pinhole as mi,
  positionOf as Xa,
  role as di,
  selection as hi,
  shown as fi,
  sub as gi,
  things as Et,
  titleOf as bi,
  tool as vi,
  turn as _a,
  useEffect as yi,
  useRef as ki,
  viewSize as wi
} from "./desk.js";

// src/later/gizmo.ts
import { project as Ga, ray as Yr } from "./desk.js";
import { across as zr, add as re, cross as jr, distance as Zr, dot as de, length as Qr, normal as xn, scale as ie, sub as Ae } from "./desk.js";
var Jr = "http://www.w3.org/2000/svg", Mn = 84, xe = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], Tt = ["x", "y", "z"], Oa = 0.1, ei = 5 * Math.PI / 180, Wa = 48;
function Ba(e, t) {
  let n = (h, v, k) => {
    let w = document.createElementNS(Jr, h);
    return w.setAttribute("class", k), v.append(w), w;
  }, a = (h, v, k) => {
    let w = n("g", e, `handle ${h} ${Tt[v] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), l = xe.map((h, v) => a("ring", v, `ring-${Tt[v]}`)), r = xe.map((h, v) => a("plane", v, `plane-${Tt[v]}`)), s = xe.map((h, v) => a("arrow", v, `move-${Tt[v]}`)), c = a("centre", -1, "move-view"), i = a("aim", -1, "aim"), p = n("text", e, "handle-text"), u = (h, v) => {
    let [k, w, I] = Ga(h.hole, v);
    return I < 0.02 && !h.hole.parallel ? null : [h.fit.x + k * h.fit.scale, h.fit.y + w * h.fit.scale];
  }, b = (h, v) => {
    let k = Ga(h.hole, v)[2];
    return Mn / h.fit.scale * h.hole.pixel * (h.hole.parallel ? 1 : Math.max(k, 0.02));
  }, d = (h, v, k = !1) => {
    let w = v.filter((L) => L !== null), I = w.length < v.length || w.length < 2 ? "" : `M${w.map((L) => `${L[0].toFixed(1)} ${L[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    h.setAttribute("d", I);
  }, m = (h, v, k) => {
    h.setAttribute("d", v ? `M${v[0] - k} ${v[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, f = (h, v) => h.forEach((k) => k.group.classList.toggle("gone", !v));
  function S(h, v) {
    let k = h.position, w = u(v, k), I = b(v, k), L = h.mode === "move";
    f([...s, ...r, c], L && w !== null), f(l, !L && w !== null && h.turns);
    let z = h.aim ?? (h.direction ? re(k, ie(h.direction, 3 * I)) : null);
    if (f([i], z !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    xe.forEach((O, _) => {
      let R = u(v, re(k, ie(O, I))), mt = R ? Math.hypot(R[0] - w[0], R[1] - w[1]) < 12 : !0;
      if (s[_].group.classList.toggle("gone", !L || mt), R && L) {
        let [ye, _e] = [(R[0] - w[0]) / Mn, (R[1] - w[1]) / Mn], ht = Math.hypot(ye, _e) || 1, [pe, Xe] = [ye / ht, _e / ht], fn = [w[0] + 14 * pe, w[1] + 14 * Xe];
        d(s[_].hit, [fn, R]), s[_].seen.setAttribute("d", `M${fn[0].toFixed(1)} ${fn[1].toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}M${(R[0] - 9 * pe - 4.5 * Xe).toFixed(1)} ${(R[1] - 9 * Xe + 4.5 * pe).toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}L${(R[0] - 9 * pe + 4.5 * Xe).toFixed(1)} ${(R[1] - 9 * Xe - 4.5 * pe).toFixed(1)}`);
      }
      let [Be, Ue] = [xe[(_ + 1) % 3], xe[(_ + 2) % 3]], Z = Math.abs(de(O, v.hole.parallel ? v.hole.forward : xn(Ae(k, v.hole.eye)))) < 0.15;
      r[_].group.classList.toggle("gone", !L || Z);
      let dt = (ye, _e) => u(v, re(k, re(ie(Be, ye * I), ie(Ue, _e * I)))), ha = [dt(0.3, 0.3), dt(0.5, 0.3), dt(0.5, 0.5), dt(0.3, 0.5)];
      if (d(r[_].hit, ha, !0), d(r[_].seen, ha, !0), !L) {
        let ye = Array.from({ length: Wa + 1 }, (_e, ht) => {
          let pe = 2 * Math.PI * ht / Wa;
          return u(v, re(k, re(ie(Be, Math.cos(pe) * I), ie(Ue, Math.sin(pe) * I))));
        });
        d(l[_].hit, ye), d(l[_].seen, ye);
      }
    }), m(c.hit, w, 13), m(c.seen, w, 7);
    let q = z && u(v, z);
    d(o, [w, q]), m(i.hit, q, 16), i.seen.setAttribute("d", q ? `M${q[0] - 8} ${q[1]}h16M${q[0]} ${q[1] - 8}v16M${q[0] - 5} ${q[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let H = t.effect(() => {
    let h = t.target.value, v = t.view.value;
    e.classList.toggle("empty", !h || !v), h && v && S(h, v);
  }), ee = (h, v, k) => Yr(h.hole, (v.clientX - k.left - h.fit.x) / h.fit.scale, (v.clientY - k.top - h.fit.y) / h.fit.scale);
  function ve(h, v, k) {
    h.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let I = t.view.peek();
      if (!I || !t.target.peek()) return;
      let L = e.getBoundingClientRect(), z = k(I), q = t.hold(v), O = ee(I, w, L);
      z(O, !1, { ...q, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), h.setPointerCapture(w.pointerId), h.classList.add("held");
      let _ = (Z) => {
        p.textContent = z(ee(I, Z, L), Z.ctrlKey || Z.metaKey, q), p.setAttribute("x", String(Z.clientX - L.left + 16)), p.setAttribute("y", String(Z.clientY - L.top - 12));
      }, R = (Z) => {
        h.removeEventListener("pointermove", _), h.removeEventListener("pointerup", mt), h.removeEventListener("pointercancel", Be), removeEventListener("keydown", Ue, !0), h.classList.remove("held"), p.textContent = "", Z ? q.end() : q.cancel();
      }, mt = () => R(!0), Be = () => R(!1), Ue = (Z) => {
        Z.key === "Escape" && (Z.stopPropagation(), R(!1));
      };
      h.addEventListener("pointermove", _), h.addEventListener("pointerup", mt), h.addEventListener("pointercancel", Be), addEventListener("keydown", Ue, !0);
    });
  }
  let dn = (h, v, k) => k ? Math.round(h / v) * v : h, hn = (h) => h.map((v) => v.toFixed(2)).join("  ") + " m";
  xe.forEach((h, v) => {
    ve(s[v].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (I, L, z) => {
        let q = ti(k, h, I);
        w ??= q;
        let O = ie(h, dn(q - w, Oa, L));
        return z.move(O), hn(O);
      };
    }), ve(r[v].group, "move", () => ma(h)), ve(l[v].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (I, L, z) => {
        let q = Ka(k.position, h, I), O = q && xn(Ae(q, k.position), zr(h));
        if (!O) return "";
        w.at ??= O;
        let _ = Math.atan2(de(h, jr(w.at, O)), de(w.at, O)), R = dn(_, ei, L);
        return z.rotate(h, R), `${(R * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), ve(c.group, "move", (h) => ma(h.hole.forward)), ve(i.group, "aim", (h) => {
    let v = t.target.peek(), k = v.aim ?? re(v.position, ie(v.direction, 3 * b(h, v.position))), w = da(k, h.hole.forward);
    return (I, L, z) => {
      let q = w(I, L), O = re(k, q);
      return Zr(O, v.position) > 1e-3 && z.turn(xn(Ae(O, v.position)), O), hn(O);
    };
  });
  function ma(h) {
    let v = da(t.target.peek().position, h);
    return (k, w, I) => {
      let L = v(k, w);
      return I.move(L), hn(L);
    };
  }
  function da(h, v) {
    let k = null;
    return (w, I) => {
      let L = Ka(h, v, w);
      return L ? (k ??= L, Ae(L, k).map((z) => dn(z, Oa, I))) : [0, 0, 0];
    };
  }
  return { stop: H };
}
function ti(e, t, n) {
  let a = Ae(e, n.origin), o = de(t, n.direction), l = 1 - o * o;
  return l < 1e-6 ? 0 : (o * de(n.direction, a) - de(t, a)) / l;
}
function Ka(e, t, n) {
  let a = de(t, n.direction);
  if (Math.abs(a) < 1e-4 * Qr(t)) return null;
  let o = de(Ae(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : re(n.origin, ie(n.direction, o));
}

// src/later/handles.tsx
import { jsx as $i } from "./desk.js";
function xi([e, t, n, a], [o, l, r, s]) {
  return [
    a * o + e * s + t * r - n * l,
    a * l - e * r + t * s + n * o,
    a * r + e * l - t * o + n * s,
    a * s - e * o - t * l - n * r
  ];
}
var Mi = () => !si.value && di.value !== "watch" && ai.value.you && vi.value !== "aim", Ya = Sn(() => {
  let e = hi.value;
  if (!e || !Mi()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => Et.get(a) && !Et.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = ni.value.filter((n) => Xa(Pt.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), za = (e) => {
  let t = Et.get(e);
  return t?.place?.position ?? (t?.box ? ui(t.box) : null);
}, ja = Sn(() => {
  let e = Ya.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? Xa(Pt.get(t)) : za(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? Pt.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: ii.value
  };
}), Si = Sn(() => {
  let e = fi.value;
  if (wi.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: mi(e.camera, t, n), fit: li(t, n) };
}), Za = {
  effect: oi,
  target: ja,
  view: Si,
  hold(e) {
    let t = Ya.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? bi(n) : n.length === 1 ? ci("thing", n[0]) : `${n.length} things`, l = new ri(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), r = a === "lamps" ? Je(n) : new Map(n.map((i) => [i, za(i)])), s = new Map(n.map((i) => [i, (a === "lamps" ? Pt : Et).get(i)?.place])), c = (i) => {
      let p = n.map((u) => [u, i(u)]).filter(([, u]) => u);
      l.set({ [a]: Object.fromEntries(p.map(([u, b]) => [u, { place: b }])) });
    };
    return {
      move: (i) => a === "lamps" ? l.set(Qe(n, i, r)) : c((p) => ({ position: Ua(r.get(p), i) })),
      turn: (i, p) => c((u) => s.get(u)?.direction ? { direction: i, ...p ? { aim: p } : {} } : null),
      rotate: (i, p) => c((u) => {
        let b = s.get(u);
        if (b?.direction) {
          let f = pi(_a(b.direction, i, p)), S = b.aim && b.position ? _a(gi(b.aim, b.position), i, p) : null;
          return { direction: f, ...S ? { aim: Ua(b.position, S) } : {} };
        }
        let d = Math.sin(p / 2), m = [i[0] * d, i[1] * d, i[2] * d, Math.cos(p / 2)];
        return { rotation: xi(m, b?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => l.end(),
      cancel: () => l.cancel()
    };
  }
}, Qa = (e) => ja.peek() ? Za.hold(e) : null;
function Ci() {
  let e = ki(null);
  return yi(() => Ba(e.current, Za).stop, []), $i("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/typed.tsx
import { jsx as Bi, jsxs as eo } from "./desk.js";
var Hi = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], Ni = { Minus: "-", NumpadSubtract: "-", Period: ".", Comma: ".", NumpadDecimal: "." }, Ja = { Enter: "keep", Escape: "leave", Backspace: "back" };
function Di({ key: e, code: t }) {
  if (Ja[e]) return { does: Ja[e] };
  let n = e.length === 1 ? "xyz".indexOf(e.toLowerCase()) : -1;
  if (n >= 0) return { axis: n };
  if (/^\d$/.test(e)) return { sign: e };
  if (/^[.,]$/.test(e)) return { sign: "." };
  if (/^[-−]$/.test(e)) return { sign: "-" };
  if (/^[a-z]$/i.test(e)) return {};
  let a = ["KeyX", "KeyY", "KeyZ"].indexOf(t);
  if (a >= 0) return { axis: a };
  let o = /^(?:Digit|Numpad)(\d)$/.exec(t)?.[1] ?? Ni[t];
  return o ? { sign: o } : {};
}
function Gi(e, t) {
  return t === "-" ? e.startsWith("-") ? e.slice(1) : `-${e}` : t === "." && e.includes(".") ? e : e.length < 9 ? e + t : e;
}
var Oi = (e) => Number(e) || 0, qe = qi(null), Se = null;
function Cn(e) {
  Me(!0), Ti.value = e, Ri.value = null, qe.value = { what: e, axis: null, text: "" };
}
function Me(e) {
  qe.peek() && (qe.value = null, e ? Se?.end() : Se?.cancel(), Se = null);
}
function Vt(e) {
  qe.value = e;
  let t = Hi[e.axis ?? 0], n = Oi(e.text);
  e.what === "move" ? Se?.move(Ii(t, n)) : Se?.rotate(t, n * Math.PI / 180);
}
function Wi(e) {
  let t = qe.peek();
  if (!t || e.key === "Shift") return !1;
  let n = e.ctrlKey || e.metaKey || e.altKey, { axis: a, sign: o, does: l } = n ? {} : Di(e);
  if (t.axis === null)
    return a === void 0 ? (Me(!1), l === "leave") : (Se = Qa(t.what), Se ? Vt({ ...t, axis: a }) : (Me(!1), Vi("Select lamps that have a place, or things that are not locked.", "warn")), !0);
  if (n)
    return Me(!0), !1;
  if (a !== void 0) Vt({ ...t, axis: a });
  else if (o) Vt({ ...t, text: Gi(t.text, o) });
  else if (l === "back") Vt({ ...t, text: t.text.slice(0, -1) });
  else if (l) Me(l === "keep");
  else return e.key.length === 1;
  return !0;
}
Pi(Wi);
addEventListener("pointerdown", (e) => Me(e.button !== 2), !0);
Li(() => {
  Ai.value, Fi(() => Me(!0));
});
function Ki() {
  let e = qe.value;
  if (!e || Ei.value === "watch") return null;
  let t = e.what === "move" ? "Move" : "Turn";
  return e.axis === null ? eo("p", { class: "hint", role: "status", children: [
    t,
    ": X, Y or Z, then ",
    e.what === "move" ? "metres" : "degrees",
    "; or drag a handle."
  ] }) : eo("p", { class: "hint", role: "status", children: [
    t,
    " ",
    e.what === "move" ? "along" : "about",
    " ",
    "XYZ"[e.axis],
    ": ",
    Bi("b", { children: e.text || "0" }),
    e.what === "move" ? " m" : "°",
    ". Enter keeps it, Esc takes it back."
  ] });
}

// src/later/actions.ts
var se = () => X() ?? (he.value.length ? null : "Select a lamp first.");
function xs() {
  let e = he.peek(), t = !e.some((n) => At.get(n)?.on);
  Pn(`${go(e)} ${t ? "on" : "off"}`, { lamps: Tn(e, { on: t }) });
}
function Ms() {
  let e = he.peek(), t = !e.every((n) => At.get(n)?.parked);
  Pn(`${t ? "Park" : "Unpark"} ${go(e)}`, { lamps: Tn(e, { parked: t }) });
}
function ho(e) {
  let t = fo.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : po.ids.peek().filter((a) => po.get(a)?.hidden);
  if (!n.length) return at(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Pn(e ? "Hide things" : "Show hidden things", { things: Tn(n, { hidden: e }) });
}
function Ss() {
  let e = he.peek()[0], t = At.get(e)?.place, n = ss();
  if (!t?.position || !t.direction || !n) return at("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  as({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function Cs() {
  Xi("command", {}, (e) => {
    Zi(e.text);
  });
}
var $s = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Ls = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, Ts = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: ns },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: os },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: ls },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: Yi },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: ts },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: vs, why: X },
  ...ms.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Ls[e],
    keys: `Shift+${t + 1}`,
    run: () => rs(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      Ln.value = Ln.peek() === "walk" ? "fly" : "walk", at(Ln.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "there", group: "View", label: "Go to the floor under the pointer", keys: "double click", run: Da, why: Na },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: Ss, why: se },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => uo(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => uo(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => Ce("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => fo.value = { kind: "lamp", ids: At.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: Ji },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: xs, why: se },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: gs, why: () => he.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: zi },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => us(!0), why: se },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Ms, why: se },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => Ce("aim"), why: se },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => nt.peek() && ze(he.peek(), nt.peek().point), why: se },
  { id: "place", group: "Lamps", label: "Put on a surface by pointing", keys: "Shift+N", run: () => Ce("place"), why: se },
  { id: "move", group: "Lamps", label: "Move: handles, or an axis and metres", keys: "G, then X Y Z, 0.5", run: () => Cn("move") },
  { id: "turn", group: "Lamps", label: "Turn: handles, or an axis and degrees", keys: "R, then X Y Z, 30", run: () => Cn("turn") },
  ...$s.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: X,
    run: () => {
      Ui.value = e, Ce("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => Mt(he.peek(), 1, [0.5, 0, 0]), why: se },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => Ea(he.peek()), why: se },
  { id: "group", group: "Lamps", label: "Group: one master for those selected", keys: "Ctrl+G", run: qa, why: () => X() ?? $t() },
  { id: "ungroup", group: "Lamps", label: "Dissolve the group, or take lamps out of it", keys: "Ctrl+Shift+G", run: Ra, why: () => X() ?? Lt() },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => ho(!0), why: X },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => ho(!1), why: X },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => $n({ do: "undo" }), why: () => X() ?? (oo.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => $n({ do: "redo" }), why: () => X() ?? (oo.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => tt.value = "save", why: X },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => tt.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Cs },
  { id: "share", group: "Work", label: "Share by link", run: () => tt.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: ys },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = es();
      e.against != null || e.quantity === "clamped" ? It({ false_color: Qi }) : It({ false_color: { ..._i(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  {
    id: "difference",
    group: "Seeing",
    label: "Difference in lux to the look stored last",
    run: () => {
      let e = cs.ids.peek().at(-1);
      e === void 0 ? at("Store a look first.") : It({ false_color: ft(e) });
    }
  },
  { id: "clamped", group: "Seeing", label: "What clamping takes, and short rays pay back", run: () => It({ false_color: va }) },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => no(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => no(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => fs({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => ji(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: ks },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: X, run: () => nt.peek() ? Ze(nt.peek().point, nt.peek().normal) : Ce("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => Ce("meter"), why: X },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => Ce("grid"), why: X },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => $n({ do: "reach", most: Ie.peek(), maintenance: ps.peek() }), why: X },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => to.value = to.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: bs, why: X },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => at("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => so.value = !so.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => ro.value = ro.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => mo.value = mo.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => lo.value = !lo.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => ao.value = !ao.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => co.value = co.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => io.value = !io.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => is.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => tt.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => tt.value = "palette" }
];
ds(Ts);
function qt() {
  return [...(hs.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...ws.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/shares.ts
import { ask as Ps, computed as Es, effect as bo, lamps as Vs, output as Is, untracked as As, what as En } from "./desk.js";
var qs = Es(() => En.value?.hit ?? null), vo = (e) => Ps("light", { point: e.point, normal: e.normal }, (t) => {
  let n = En.peek();
  n?.hit === e && (En.value = {
    ...n,
    lux: t.lux ?? n.lux,
    lamps: t.lamps ?? n.lamps,
    done: t.done !== !1
  });
});
bo(() => {
  let e = qs.value;
  if (!e) return;
  let t = As(() => vo(e)), n = null, a = !0, o = bo(() => {
    for (let [, l] of Vs.all()) Is(l);
    n !== null && clearTimeout(n), a || (n = window.setTimeout(() => {
      t(), t = vo(e);
    }, 250)), a = !1;
  });
  return () => {
    t(), o(), n !== null && clearTimeout(n);
  };
});

// src/later/compare.tsx
import { before as Rs, comparing as Fs, digits as Hs, fitted as Ns, useEffect as Ds, useRef as Gs, viewSize as Os, wipeAt as Vn } from "./desk.js";
import { Fragment as Ks, jsx as In, jsxs as Bs } from "./desk.js";
function Ws() {
  let e = Fs.value, t = Rs.value, n = Gs(null);
  if (Ds(() => {
    let i = n.current;
    !i || !t || (i.width = t.picture.width, i.height = t.picture.height, i.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = Os.value, o = Vn.value, l = Ns(t.picture.width, t.picture.height), r = Math.max(0, Math.min(1, (o * a - l.x) / (t.picture.width * l.scale))), s = (i) => {
    let p = i.currentTarget;
    if (i.stopPropagation(), i.type === "pointerdown") p.setPointerCapture(i.pointerId);
    else if (p.hasPointerCapture(i.pointerId)) {
      let u = p.parentElement.getBoundingClientRect();
      Vn.value = Math.max(0, Math.min(1, (i.clientX - u.left) / u.width));
    }
  }, c = (i) => {
    let p = { ArrowLeft: -0.02, ArrowRight: 0.02 }[i.key];
    p && (i.stopPropagation(), i.preventDefault(), Vn.value = Math.max(0, Math.min(1, o + p)));
  };
  return Bs(Ks, { children: [
    In(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * r}% 0 0)` : "none" }
      }
    ),
    In("span", { class: "tag left", children: "before" }),
    e === "wipe" && In(
      "div",
      {
        class: "wipe",
        "data-handle": "wipe",
        role: "slider",
        tabIndex: 0,
        "aria-label": "Wipe between before and now",
        "aria-valuemin": 0,
        "aria-valuemax": 100,
        "aria-valuenow": Math.round(o * 100),
        "aria-valuetext": `${Hs(o * 100)} % before`,
        style: { left: `${100 * o}%` },
        onPointerDown: s,
        onPointerMove: s,
        onKeyDown: c
      }
    )
  ] });
}

// src/later/inspector.tsx
import { act as kl, deselect as Qu, Icon as Jn, penless as ea, selection as Ju, signal as ec } from "./desk.js";

// src/later/measure.tsx
import {
  add as Zs,
  deselect as Eo,
  digits as $e,
  dot as Qs,
  edit as Ot,
  grids as Js,
  Icon as Vo,
  length as Gt,
  maintained as He,
  maintenance as eu,
  meters as tu,
  scale as nu,
  selection as Io,
  up as To
} from "./desk.js";

// src/later/figures.tsx
import { maintenance as ko, status as An } from "./desk.js";

// src/later/verdict.ts
function yo(e, t) {
  let n = ({ value: o, error: l, least: r }) => {
    let s = t ? 0 : l ?? 1 / 0;
    return o - s >= r ? "met" : o + s < r ? "missed" : "open";
  }, a = e.map(n);
  return a.includes("missed") ? "missed" : a.includes("open") ? "open" : "met";
}

// src/later/figures.tsx
import { jsx as $o } from "./desk.js";
var wo = () => An.value?.stage === "moving" || An.value?.stage === "loading", Us = () => wo() || An.value?.stage === "refining", xo = { meter: 0.02, grid: 0.05 };
function Mo(e, t, n) {
  return e == null || t == null || t > n * e || Us();
}
var Rt = ({ lux: e }) => Mo(e?.[0], e?.[1], xo.meter), Ft = ({ mean: e, error: t }) => Mo(e, t, xo.grid), So = (e, t) => wo() ? "open" : yo(e, t === !0);
function Ht({ lux: e, target: t, done: n }) {
  if (!e || !t) return null;
  let a = ko.value;
  return So([{ value: e[0] * a, error: e[1] == null ? null : e[1] * a, least: t }], n);
}
function Nt({ mean: e, error: t, uniformity: n, uniformity_error: a, target: o, done: l }) {
  if (!o || e == null || n == null) return null;
  let r = ko.value;
  return So([
    { value: e * r, error: t == null ? null : t * r, least: o.lux },
    { value: n, error: a ?? null, least: o.uniformity }
  ], l);
}
var Co = {
  met: ["✓", "reaches its target"],
  missed: ["✗", "misses its target"],
  open: ["≈", "within its ± of the target: not decided yet"]
};
function qn({ of: e }) {
  if (!e) return null;
  let [t, n] = Co[e];
  return $o("b", { class: e, role: "img", "aria-label": n, title: n, children: t });
}
function Rn({ of: e }) {
  if (!e) return null;
  let [t, n] = Co[e];
  return $o("p", { class: e, children: `${t} ${n[0].toUpperCase()}${n.slice(1)}` });
}

// src/later/parts.tsx
import { Field as Lo, Gesture as _s, Range as Xs, stroke as Ys, useRef as zs } from "./desk.js";
import { jsx as ue, jsxs as Dt } from "./desk.js";
function A({ title: e, note: t, children: n }) {
  return Dt("section", { class: "part", "aria-label": e, children: [
    Dt("h3", { children: [
      e,
      t && ue("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function B(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function E(e) {
  return Dt("label", { class: "line", children: [
    ue("span", { children: e.label }),
    ue(Lo, { ...e, label: e.name ?? e.label })
  ] });
}
function js(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function Q({ label: e, names: t, quantity: n, value: a, set: o, step: l, disabled: r }) {
  let s = t ?? ["X", "Y", "Z"];
  return Dt("div", { class: "line", role: "group", "aria-label": e, children: [
    ue("span", { children: e }),
    ue("span", { class: "triple", children: s.map((c, i) => ue(
      Lo,
      {
        label: `${e} ${c}`,
        quantity: n,
        value: a[i],
        text: js(a[i], n),
        step: l,
        disabled: r,
        set: (p) => o(i, p)
      },
      c
    )) })
  ] });
}
function Re({ label: e, name: t, value: n, text: a, patch: o, reset: l, notch: r, class: s, style: c, disabled: i }) {
  let p = zs(null), u = (d) => () => {
    p.current?.[d](), p.current = null;
  }, b = (d) => p.current ? p.current.set(o(d)) : Ys(e + t, t, o(d));
  return ue(
    Xs,
    {
      label: e,
      value: n,
      text: a,
      notch: r,
      class: s,
      gradient: c,
      disabled: i,
      begin: () => p.current = new _s(t),
      on: b,
      end: u("end"),
      cancel: u("cancel"),
      reset: l === void 0 ? void 0 : () => b(l)
    }
  );
}
function Fe({ value: e, label: t, set: n }) {
  return ue("span", { class: "field name-field", children: ue(
    "input",
    {
      type: "text",
      "aria-label": t,
      value: e,
      maxLength: 120,
      spellcheck: !1,
      onChange: (a) => {
        let o = a.currentTarget.value.trim();
        o && o !== e ? n(o) : a.currentTarget.value = e;
      },
      onKeyDown: (a) => {
        a.key === "Enter" && a.currentTarget.blur(), a.key === "Escape" && (a.stopPropagation(), a.currentTarget.value = e, a.currentTarget.blur());
      }
    }
  ) });
}
var ce = (e, t, n) => e.map((a, o) => o === t ? n(a) : a);

// src/later/measure.tsx
import { Fragment as Fn, jsx as C, jsxs as Y } from "./desk.js";
var au = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function Ao() {
  let e = Io.value?.ids[0], t = tu.get(e);
  if (!t) return C("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: l, done: r, ...s } = { ...t, ...o };
    Ot(`${t.name}: ${a}`, { meters: { [e]: s } });
  };
  return Y(Fn, { children: [
    C("header", { class: "panel-head", children: C(Fe, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    C("p", { class: `crumbs ${Rt(t) ? "unsettled" : "known"}`, children: t.lux?.[1] != null ? `${He(t.lux[0])} ±${He(t.lux[1], !1)}` : "measuring" }),
    C("div", { class: "scroll", children: Y(A, { title: "Meter", children: [
      Y("label", { class: "line", children: [
        C("span", { children: "Measures" }),
        C("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: au.map(([a, o]) => C("option", { value: a, children: o }, a)) })
      ] }),
      C(Q, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: ce(t.point, a, o) }) }),
      C(E, { label: "At least", quantity: "lux", step: 50, value: t.target ?? 0, set: (a) => n("target", { target: a(t.target ?? 0) || null }) }),
      C(Rn, { of: Ht(t) }),
      C(Q, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: ce(t.normal, a, o) }) }),
      Y("button", { class: "plain full", onClick: () => {
        Eo(), Ot(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        C(Vo, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var Po = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function qo() {
  let e = Io.value?.ids[0], t = Js.get(e);
  if (!t) return C("p", { class: "quiet empty", children: "This grid is gone." });
  let n = eu.value, a = (i, p) => {
    let { name: u, corner: b, u: d, v: m, normal: f, columns: S, rows: H, border: ee, target: ve } = { ...t, ...p };
    Ot(`${t.name}: ${i}`, { grids: { [e]: { name: u, corner: b, u: d, v: m, normal: f, columns: S, rows: H, border: ee, target: ve } } });
  }, o = (i, p = t.border) => {
    let [u, b] = yn([gt(Gt(t.u), p), gt(Gt(t.v), p)]);
    a(i, { columns: u, rows: b, border: p });
  }, l = Qs(t.corner, To.value) - bt(), r = (i, p, u) => Y(Fn, { children: [
    C("dt", { children: i }),
    C("dd", { children: p == null ? "…" : u(p) })
  ] }), s = (i, p) => i == null ? "" : ` ±${p(i)}`, c = t.target ?? { lux: 500, uniformity: 0.6 };
  return Y(Fn, { children: [
    C("header", { class: "panel-head", children: C(Fe, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    Y("p", { class: "crumbs", children: [
      $e(Gt(t.u), 2),
      " × ",
      $e(Gt(t.v), 2),
      " m, ",
      $e(t.columns * t.rows),
      " points"
    ] }),
    Y("div", { class: "scroll", children: [
      C(A, { title: "Figures", note: n === 1 ? "new" : `× ${$e(n, 2)}`, children: Y("dl", { class: `figures ${Ft(t) ? "unsettled" : ""}`, children: [
        r("Ē", t.mean, (i) => He(i) + s(t.error, (p) => He(p, !1))),
        r("E min", t.min, (i) => He(i)),
        r("E max", t.max, (i) => He(i)),
        r("U₀ = min / mean", t.uniformity, (i) => $e(i, 2) + s(t.uniformity_error, (p) => $e(p, 2))),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => $e(i, 2))
      ] }) }),
      Y(A, { title: "Target", children: [
        C(Rn, { of: Nt(t) }),
        Y("label", { class: "line", children: [
          C("span", { children: "Class" }),
          Y("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let p = Po[Number(i.currentTarget.value)];
            a("target", { target: p ? { lux: p[1], uniformity: p[2] } : null });
          }, children: [
            C("option", { value: "", children: t.target ? "choose…" : "none" }),
            Po.map(([i, p, u], b) => Y("option", { value: b, children: [
              i,
              ": ",
              p,
              " lx, U₀ ",
              u
            ] }, i)),
            C("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        C(E, { label: "Ē at least", quantity: "lux", step: 50, value: c.lux, set: (i) => a("target", { target: { ...c, lux: i(c.lux) } }) }),
        C(E, { label: "U₀ at least", quantity: "share", step: 0.05, value: c.uniformity, set: (i) => a("target", { target: { ...c, uniformity: i(c.uniformity) } }) })
      ] }),
      Y(A, { title: "Area", children: [
        C(Q, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, p) => a("move", { corner: ce(t.corner, i, p) }) }),
        C(E, { label: "Height", name: "Height above the floor", quantity: "length", step: 0.01, value: l, set: (i) => a("height", { corner: Zs(t.corner, nu(To.value, i(l) - l)) }) }),
        C(E, { label: "Border", quantity: "length", step: 0.05, value: t.border ?? 0, set: (i) => o("border", Math.max(0, i(t.border ?? 0))) }),
        C(E, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        C(E, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        C("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: () => o("standard spacing"), children: "Spacing of the standard" }),
        Y("button", { class: "plain full", onClick: () => {
          Eo(), Ot(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          C(Vo, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as oe,
  chosenLamps as bu,
  dot as On,
  edit as Bt,
  format as Uo,
  groups as Ut,
  handles as Wt,
  Icon as De,
  lamps as Bn,
  layers as vu,
  lumensOf as yu,
  normal as _o,
  output as ku,
  percent as Kn,
  positionOf as Do,
  selection as Xo,
  signal as Yo,
  spot as wu,
  sub as Go,
  titleOf as Un,
  tool as zo,
  toLevel as Oo,
  toTravel as xu,
  typeLevel as Wn,
  up as Mu,
  Fade as Su,
  Field as Cu,
  wantLevel as Wo,
  compass as jo,
  add as _t,
  scale as Ge,
  length as $u,
  Range as Lu,
  strokeLevel as Ko,
  typeGroupLevel as Tu,
  useRef as Pu
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as iu,
  digits as Fo,
  edit as su,
  fromHex as uu,
  hex as cu,
  lamps as Ho,
  mired as Le,
  titleOf as pu
} from "./desk.js";

// src/later/white.ts
import { css as ou, mired as Hn } from "./desk.js";
function lu(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((l) => Math.max(0, l));
}
function ru(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function Ro(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, l) => {
    let r = Hn(e) + (Hn(t) - Hn(e)) * l / (n - 1);
    return ou(lu(...ru(1e6 / r)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as Dn, jsx as D, jsxs as fe } from "./desk.js";
var ot = 1800, Gn = 1e4, mu = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], du = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], hu = Ro(ot, Gn), Nn = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(Ho.get(n).color) }]))
}), fu = (e) => {
  let t = 1e6 / (Le(ot) + (Le(Gn) - Le(ot)) * e);
  return Math.round(t / 10) * 10;
}, gu = (e) => (Le(e) - Le(ot)) / (Le(Gn) - Le(ot));
function No() {
  let e = iu.value, t = e.map((r) => Ho.get(r)?.color).filter((r) => r !== void 0);
  if (!t.length) return null;
  let n = B(t.map((r) => r.mode)), a = t[0], o = pu(e), l = (r, s) => su(`${o}: ${r}`, Nn(e, s));
  return fe(Dn, { children: [
    fe("div", { class: "line", children: [
      D("span", { children: "Colour" }),
      D("div", { class: "segments", role: "group", "aria-label": "Colour by", children: du.map(([r, s]) => D("button", { "aria-pressed": n === r, onClick: () => l(`colour by ${s}`, () => ({ mode: r })), children: s }, r)) })
    ] }),
    n === "kelvin" && fe(Dn, { children: [
      fe("div", { class: "line slide", children: [
        D("span", { children: "White" }),
        D(
          Re,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: hu,
            value: gu(a.kelvin),
            text: `${Fo(a.kelvin)} kelvin`,
            patch: (r) => Nn(e, () => ({ mode: "kelvin", kelvin: fu(r) }))
          }
        )
      ] }),
      D(
        E,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: B(t.map((r) => r.kelvin)),
          step: 50,
          set: (r) => l("white", (s) => ({ mode: "kelvin", kelvin: r(s.kelvin) }))
        }
      ),
      D("div", { class: "whites", role: "group", "aria-label": "Whites", children: mu.map(([r, s]) => D("button", { title: s, "aria-label": `${r} kelvin, ${s}`, onClick: () => l(`${r} K`, () => ({ mode: "kelvin", kelvin: r })), children: r }, r)) }),
      fe("div", { class: "line slide", children: [
        D("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        D(
          Re,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${Fo(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (r) => Nn(e, () => ({ tint: Math.round((r * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      D(E, { label: "", name: "Tint, typed", quantity: "number", value: B(t.map((r) => r.tint)), step: 1, set: (r) => l("tint", (s) => ({ tint: Math.max(-50, Math.min(50, r(s.tint))) })) })
    ] }),
    n === "rgb" && fe(Dn, { children: [
      fe("label", { class: "line", children: [
        D("span", { children: "Colour" }),
        D("input", { type: "color", class: "pick", "aria-label": "Colour", value: cu(a.rgb), onChange: (r) => l("colour", () => ({ mode: "rgb", rgb: uu(r.currentTarget.value) })) })
      ] }),
      D(
        Q,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (r, s) => l("colour", (c) => ({ rgb: c.rgb.map((i, p) => p === r ? Math.max(0, s(i)) : i) }))
        }
      )
    ] }),
    n === "xy" && fe("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      D("span", { children: "x, y" }),
      D("span", { class: "triple", children: [0, 1].map((r) => D(
        E,
        {
          label: "xy"[r],
          quantity: "number",
          step: 1e-3,
          value: B(t.map((s) => s.xy[r])),
          set: (s) => l("chromaticity", (c) => ({ xy: c.xy.map((i, p) => p === r ? Math.max(0.01, Math.min(0.9, s(i))) : i) }))
        },
        r
      )) })
    ] }),
    n === null && D("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as _n, jsx as y, jsxs as G } from "./desk.js";
var Ne = Yo(1), Kt = Yo([1, 0, 0]), Eu = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], Xt = 180 / Math.PI;
function Bo(e, t) {
  let { right: n, ahead: a } = jo(t), o = -On(e, t);
  return [Math.atan2(On(e, n), On(e, a)) * Xt, Math.asin(Math.max(-1, Math.min(1, o))) * Xt];
}
function Vu(e, t, n) {
  let { right: a, ahead: o } = jo(n), [l, r] = [e / Xt, t / Xt], s = _t(Ge(a, Math.sin(l)), Ge(o, Math.cos(l)));
  return _o(_t(Ge(s, Math.cos(r)), Ge(n, -Math.sin(r))));
}
function Iu({ ids: e, all: t }) {
  let n = t.some((o) => o.place?.direction), a = Xo.value?.kind === "group";
  return G("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    G("button", { "aria-pressed": zo.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => oe("aim"), children: [
      y(De, { name: "aim" }),
      "Aim"
    ] }),
    y("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => oe("solo"), children: y(De, { name: "solo" }) }),
    y("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => oe("from-lamp"), children: y(De, { name: "eye" }) }),
    y("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => oe("frame"), children: y(De, { name: "frame" }) }),
    y("span", { class: "gap" }),
    $t() === null && y("button", { title: "Group (Ctrl+G): one master for all of them", onClick: () => oe("group"), children: "Group" }),
    Lt() === null && y("button", { title: a ? "Dissolve the group (Ctrl+Shift+G): its lamps stay" : "Take out of the group (Ctrl+Shift+G)", onClick: () => oe("ungroup"), children: a ? "Dissolve" : "Take out" }),
    y("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((o) => o.parked), onClick: () => oe("park"), children: "Park" }),
    y("button", { class: "icon", "aria-label": `Remove ${Un(e)}`, title: "Remove (Del)", onClick: () => oe("remove"), children: y(De, { name: "bin" }) })
  ] });
}
function Au({ ids: e, all: t }) {
  let n = B(t.map((r) => r.level)), a = yu(e), o = t.every((r) => r.free), l = e[e.length - 1];
  return G(A, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    G("div", { class: "line slide", children: [
      y("span", { children: "Level" }),
      y(qu, { id: l })
    ] }),
    G("label", { class: "line", children: [
      y("span", {}),
      y(
        Cu,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: B(t.map((r) => r.flux)) ?? void 0,
          step: 0.01,
          set: (r) => Wn(e, r),
          open: Wo.value,
          opened: () => Wo.value = "",
          id: "level"
        }
      )
    ] }),
    y(
      E,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (r) => Wn(e, (s, c) => r(s * c) / c)
      }
    ),
    G("div", { class: "line", children: [
      y("span", { children: "Stops" }),
      y("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: Eu.map(([r, s]) => y("button", { "aria-label": `${s} stop`, onClick: () => Wn(e, (c) => Math.min(1e3, c * 2 ** r)), children: s }, s)) })
    ] }),
    G("p", { class: "sum", children: [
      Uo(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (Ut.get(t[0].group)?.level ?? 1) !== 1 && ` (${Kn(t[0].level)} % × ${Kn(Ut.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    y(No, {})
  ] });
}
function qu({ id: e }) {
  let t = Pu(null), n = Bn.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (l) => () => {
    t.current?.[l](), t.current = null;
  };
  return y(
    Lu,
    {
      label: "Level",
      value: xu(n.level),
      text: `${Kn(n.level)} %, ${Uo(n.flux * ku(n), "flux")}`,
      begin: () => t.current = new Su(a),
      on: (l) => t.current ? t.current.to(Oo(l)) : Ko(a, Oo(l)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => Ko(a, 1)
    }
  );
}
function lt(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = Bn.get(o), r = n(l.place ?? {}, l);
    r && (a[o] = { place: r });
  }
  Object.keys(a).length && Bt(`${Un(e)}: ${t}`, { lamps: a });
}
function Ru({ ids: e, all: t }) {
  let n = (o) => B(t.map((l) => l.place?.[o] ?? null)), a = (o) => t.some((l) => l.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : G(A, { title: "Beam", note: "re-trace", children: [
    a("outer") && G(_n, { children: [
      y(E, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => lt(e, "beam", (l) => l.outer == null ? null : { inner: Math.max(0.1, Math.min(l.outer, o(l.inner ?? l.outer))) }) }),
      y(E, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => lt(e, "beam", (l) => {
        if (l.outer == null) return null;
        let r = Math.max(0.2, Math.min(179, o(l.outer)));
        return { outer: r, inner: Math.min(l.inner ?? r, r) };
      }) })
    ] }),
    a("radius") && y(E, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => lt(e, "radius", (l) => l.radius == null ? null : { radius: Math.max(1e-3, o(l.radius)) }) })
  ] });
}
function Fu({ ids: e, all: t }) {
  let n = t.filter((u) => Do(u) !== null);
  if (!n.length) return null;
  let a = n.map((u) => Do(u)), o = (u, b) => B(b.map((d) => Math.round(d[u] * 1e4) / 1e4)), l = t.filter((u) => u.place?.direction), r = Mu.value, s = l.map((u) => Bo(u.place?.direction, r).map((b) => Math.round(b * 10) / 10)), c = t.map((u) => u.place?.aim).filter((u) => !!u), i = (u, b) => {
    let d = Je(e), m = {};
    for (let [f, S] of d) {
      let H = [0, 0, 0];
      H[u] = b(S[u]) - S[u], Object.assign(m, Qe([f], H, d).lamps);
    }
    Bt(`Move ${Un(e)}`, { lamps: m });
  }, p = (u, b) => lt(e, u ? "tilt" : "pan", (d) => {
    if (!d.direction) return null;
    let m = Bo(d.direction, r);
    m[u] = b(m[u]);
    let f = Vu(m[0], Math.max(-90, Math.min(90, m[1])), r), S = d.aim && d.position ? $u(Go(d.aim, d.position)) : 0;
    return { direction: f, ...S && d.position ? { aim: _t(d.position, Ge(f, S)) } : {} };
  });
  return G(A, { title: "Place", note: "re-trace", children: [
    y(Q, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((u) => o(u, a)), set: i }),
    l.length > 0 && G(_n, { children: [
      y(E, { label: "Pan", quantity: "angle", step: 1, value: B(s.map((u) => u[0])), set: (u) => p(0, u) }),
      y(E, { label: "Tilt", quantity: "angle", step: 1, value: B(s.map((u) => u[1])), set: (u) => p(1, u) }),
      y(
        Q,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: c.length ? [0, 1, 2].map((u) => o(u, c)) : [NaN, NaN, NaN],
          set: (u, b) => lt(e, "aim", (d) => {
            if (!d.direction || !d.position) return null;
            let m = ce(d.aim ?? _t(d.position, Ge(d.direction, 2)), u, b);
            return { aim: m, direction: _o(Go(m, d.position)) };
          })
        }
      )
    ] }),
    G("div", { class: "line", children: [
      y("span", { children: "Handles" }),
      G("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        y("button", { "aria-pressed": Wt.value === "move", onClick: () => Wt.value = "move", children: "Move" }),
        y("button", { "aria-pressed": Wt.value === "turn", onClick: () => Wt.value = "turn", children: "Turn" })
      ] })
    ] }),
    y("button", { class: "plain full", "aria-pressed": zo.value === "place", onClick: () => oe("place"), children: "Put on a surface by pointing" }),
    l.length > 0 && wu.value && y("button", { class: "plain full", onClick: () => oe("aim-here"), children: "Aim at the last point" })
  ] });
}
function Hu({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : G(A, { title: "Copies along a line", children: [
    y(E, { label: "How many", quantity: "number", step: 1, value: Ne.value, set: (n) => Ne.value = Math.max(1, Math.min(100, Math.round(n(Ne.value)))) }),
    y(Q, { label: "Step", quantity: "length", step: 0.05, value: Kt.value, set: (n, a) => Kt.value = ce(Kt.value, n, a) }),
    G("button", { class: "plain full", onClick: () => Mt(e, Ne.value, Kt.value), children: [
      y(De, { name: "copy" }),
      Ne.value === 1 ? "One copy" : `${Ne.value} copies`
    ] })
  ] });
}
function Zo() {
  let e = bu.value, t = e.map((s) => Bn.get(s)).filter((s) => !!s);
  if (!t.length) return y("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && Ut.get(n.group), o = Xo.value, l = o?.kind === "group" && o.ids.length === 1 ? Ut.get(o.ids[0]) : void 0, r = n?.layer != null ? vu.value[n.layer] : void 0;
  return G(_n, { children: [
    y("header", { class: "panel-head", children: l && o ? y(Fe, { label: "Name of the group", value: l.name, set: (s) => Bt(`Rename ${l.name}`, { groups: { [o.ids[0]]: { name: s } } }) }) : n ? y(Fe, { label: "Name of the lamp", value: n.name, set: (s) => Bt(`Rename ${n.name}`, { lamps: { [e[0]]: { name: s } } }) }) : G("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    y("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((s) => s.on).length} of ${t.length} on` }),
    G("div", { class: "scroll", children: [
      y(Iu, { ids: e, all: t }),
      l && o && y(A, { title: "Group", note: "re-mix", children: y(E, { label: "Master", name: "Master of the group", quantity: "level", step: 0.01, value: l.level, set: (s) => Tu(o.ids[0], s) }) }),
      y(Au, { ids: e, all: t }),
      y(A, { title: "Photometry", children: y("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      y(Ru, { ids: e, all: t }),
      y(Fu, { ids: e, all: t }),
      y(Hu, { ids: e, all: t }),
      y("p", { class: "cost", children: t.every((s) => s.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as Xn,
  candles as Yt,
  command as Nu,
  digits as jt,
  edit as Qo,
  Field as Jo,
  filterOf as al,
  go as Du,
  history as Gu,
  hovered as el,
  Icon as Zt,
  layers as Ou,
  lookOnly as tl,
  maintenance as Oe,
  materials as Wu,
  percent as Ku,
  scene as Bu,
  select as ol,
  signal as Uu,
  singleKeys as nl,
  sub as _u,
  things as Xu,
  travel as zt,
  Virtual as ll,
  workPlane as Yn
} from "./desk.js";
import { Fragment as Yu, jsx as M, jsxs as V } from "./desk.js";
function rl() {
  let e = Bu.value;
  if (!e) return null;
  let t = _u(e.bounds[1], e.bounds[0]);
  return V(Yu, { children: [
    V(A, { title: "Room", children: [
      V("p", { children: [
        t.map((n) => jt(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${jt(e.triangles)} triangles` : ""
      ] }),
      M("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && M("ul", { class: "buttons", children: e.cameras.map((n, a) => M("li", { children: M("button", { onClick: () => Du(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && V("details", { children: [
        V("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        M("ul", { class: "remarks", children: e.warnings.map((n) => M("li", { children: n }, n)) })
      ] })
    ] }),
    V(A, { title: "Figures", children: [
      V("label", { class: "line", children: [
        M("span", { children: "Maintenance" }),
        M(Jo, { label: "Maintenance factor", quantity: "share", value: Oe.value, step: 0.05, set: (n) => Oe.value = Math.max(0.1, Math.min(1, n(Oe.value))) })
      ] }),
      V("p", { class: "quiet", children: [
        Oe.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Oe.value === 1 && M("button", { class: "plain", onClick: () => Oe.value = 0.8, children: "0.80" })
      ] }),
      V("label", { class: "line", children: [
        M("span", { children: "Work plane" }),
        M(Jo, { label: "Work plane above the floor", quantity: "length", value: Yn.value, step: 0.05, set: (n) => Yn.value = Math.max(0, Math.min(3, n(Yn.value))) })
      ] }),
      V("div", { class: "line", children: [
        M("span", { children: "Unit" }),
        V("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          M("button", { "aria-pressed": Yt.value === "lx", onClick: () => Yt.value = "lx", children: "lx, cd/m²" }),
          M("button", { "aria-pressed": Yt.value === "fc", onClick: () => Yt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    M(A, { title: "Layers of light", children: M("ul", { class: "layers", children: Ou.value.map((n, a) => V("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      M("i", { class: "dot", "aria-hidden": "true" }),
      M("span", { children: n.name || `layer ${a + 1}` }),
      M("small", { children: n.held ? "held" : Ku(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    V(A, { title: "Hands", children: [
      V("div", { class: "line", children: [
        M("span", { children: "Faders" }),
        V("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          M("button", { "aria-pressed": zt.value === "square", onClick: () => zt.value = "square", children: "Square law" }),
          M("button", { "aria-pressed": zt.value === "linear", onClick: () => zt.value = "linear", children: "Even" })
        ] })
      ] }),
      V("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: nl.value, onChange: (n) => nl.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      V("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: tl.value, onChange: (n) => tl.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var Qt = Uu("");
function il({ label: e }) {
  return M("span", { class: "field filter", children: M("input", { type: "text", "aria-label": e, placeholder: "Filter", value: Qt.value, onInput: (t) => Qt.value = t.currentTarget.value }) });
}
function sl() {
  let e = al(Xu, Qt.value);
  return V("div", { class: "listing", children: [
    M(il, { label: "Filter things" }),
    M(
      ll,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return V("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => el.value = { kind: "thing", id: n }, onPointerLeave: () => el.value = null, children: [
            M("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => Qo(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: M(Zt, { name: a.hidden ? "eye-off" : "eye" }) }),
            M("button", { class: "row-name", onClick: () => ol("thing", n), children: M("span", { children: a.name }) }),
            M("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => Qo(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: M(Zt, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function ul() {
  let e = al(Wu, Qt.value);
  return V("div", { class: "listing", children: [
    M(il, { label: "Filter materials" }),
    M(
      ll,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return V("div", { class: "sheet-row material", role: "listitem", children: [
            M("button", { class: "row-name", onClick: () => ol("material", n), children: M("span", { children: a.name }) }),
            V("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${jt(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function cl() {
  let e = Gu.value;
  return V(A, { title: "History", children: [
    V("p", { children: [
      e.steps === 1 ? "One step" : `${jt(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => Xn("undo"), children: [
      M(Zt, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => Xn("redo"), children: [
      M(Zt, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    M("button", { class: "plain full", onClick: () => Xn("save"), children: "Save a version with a name…" }),
    M("button", { class: "plain full", onClick: () => Nu({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as zn,
  edit as hl,
  fromHex as zu,
  hex as ju,
  Icon as pl,
  materials as fl,
  middle as ml,
  select as gl,
  selection as bl,
  things as jn
} from "./desk.js";
import { Fragment as Qn, jsx as T, jsxs as j } from "./desk.js";
var Zn = 180 / Math.PI;
function dl(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * Zn : 0;
}
function Zu(e, t) {
  let n = [0, 0, 0, Math.cos(t / Zn / 2)];
  return n[e] = Math.sin(t / Zn / 2), n;
}
function vl() {
  let e = (bl.value?.ids ?? []).filter((c) => jn.get(c)), t = e.map((c) => jn.get(c));
  if (!t.length) return T("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((c) => c.locked), l = (c, i) => hl(`${a}: ${c}`, { things: Object.fromEntries(e.map((p, u) => [p, i(t[u])])) }), r = t.map((c) => c.place?.position ?? (c.box ? ml(c.box) : [0, 0, 0])), s = n.box ? [0, 1, 2].map((c) => n.box[1][c] - n.box[0][c]) : null;
  return j(Qn, { children: [
    T("header", { class: "panel-head", children: T("h2", { children: a }) }),
    s && j("p", { class: "crumbs", children: [
      s.map((c) => zn(c, 2)).join(" × "),
      " m"
    ] }),
    j("div", { class: "scroll", children: [
      j("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        j("button", { "aria-pressed": t.every((c) => c.hidden), onClick: () => l(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          T(pl, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        j("button", { "aria-pressed": o, onClick: () => l(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          T(pl, { name: o ? "lock" : "unlock" }),
          o ? "Locked" : "Lock"
        ] })
      ] }),
      j(A, { title: "Place", note: "re-trace", children: [
        o && T("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        T(
          Q,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: o,
            value: [0, 1, 2].map((c) => B(r.map((i) => Math.round(i[c] * 1e4) / 1e4))),
            set: (c, i) => l("move", (p) => ({ place: { position: ce(p.place?.position ?? ml(p.box), c, i) } }))
          }
        ),
        [0, 1, 2].map((c) => T(
          E,
          {
            label: `Turn ${"XYZ"[c]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: B(t.map((i) => Math.round(dl(i.place?.rotation, c) * 10) / 10)),
            set: (i) => l("turn", (p) => ({ place: { rotation: Zu(c, i(dl(p.place?.rotation, c))) } }))
          },
          c
        )),
        T(
          E,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: o,
            value: B(t.map((c) => c.place?.scale ?? 1)),
            set: (c) => l("scale", (i) => ({ place: { scale: Math.max(1e-3, c(i.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      T(A, { title: "Materials", children: T("ul", { class: "buttons", children: n.materials.map((c) => T("li", { children: T("button", { onClick: () => gl("material", c), children: fl.get(c)?.name ?? `material ${c}` }) }, c)) }) })
    ] })
  ] });
}
function yl() {
  let e = bl.value?.ids[0], t = fl.get(e);
  if (!t) return T("p", { class: "quiet empty", children: "This material is gone." });
  let n = (i, p) => hl(`${t.name}: ${i}`, { materials: { [e]: p } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], r = ((i) => 0.2126 * i[0] + 0.7152 * i[1] + 0.0722 * i[2])(o), s = (i) => o.map((p) => Math.max(0, Math.min(1, r > 1e-4 ? p / r * i : i))), c = (i, p) => t[p] != null && j(Qn, { children: [
    j("div", { class: "line slide", children: [
      T("span", { children: i }),
      T(Re, { label: i, name: `${t.name}: ${i.toLowerCase()}`, value: t[p], text: zn(t[p], 2), patch: (u) => ({ materials: { [e]: { [p]: Math.round(u * 1e3) / 1e3 } } }) })
    ] }),
    T(E, { label: "", name: `${i}, typed`, quantity: "share", step: 0.01, value: t[p], set: (u) => n(i.toLowerCase(), { [p]: Math.max(0, Math.min(1, u(t[p]))) }) })
  ] });
  return j(Qn, { children: [
    T("header", { class: "panel-head", children: T("h2", { children: t.name }) }),
    T("p", { class: "crumbs", children: t.kind }),
    j("div", { class: "scroll", children: [
      j(A, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        j("div", { class: "line slide", children: [
          T("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          T(Re, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: r, text: zn(r, 2), patch: (i) => ({ materials: { [e]: { [a]: s(Math.min(0.95, i)) } } }) })
        ] }),
        T(E, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(r * 1e3) / 1e3, set: (i) => n("reflectance", { [a]: s(Math.min(0.98, i(r))) }) }),
        j("label", { class: "line", children: [
          T("span", { children: "Colour" }),
          T("input", { type: "color", class: "pick", "aria-label": "Colour", value: ju(o), onChange: (i) => n("colour", { [a]: zu(i.currentTarget.value) }) })
        ] }),
        c("Roughness", "roughness"),
        c("Gloss", "specular")
      ] }),
      T(A, { title: "On", children: T("ul", { class: "buttons", children: jn.all().filter(([, i]) => i.materials.includes(e)).slice(0, 40).map(([i, p]) => T("li", { children: T("button", { onClick: () => gl("thing", i), children: p.name }) }, i)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as wl, jsx as N, jsxs as Jt } from "./desk.js";
var rt = ["Scene", "Things", "Materials", "History"], ge = ec("Scene");
function tc() {
  let e = { Scene: rl, Things: sl, Materials: ul, History: cl }[ge.value];
  return Jt(wl, { children: [
    N("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), ge.value = rt[(rt.indexOf(ge.value) + a + rt.length) % rt.length], document.getElementById(`tab-${ge.value}`)?.focus());
    }, children: rt.map((n) => N("button", { id: `tab-${n}`, role: "tab", "aria-selected": ge.value === n, "aria-controls": "tab-panel", tabIndex: ge.value === n ? 0 : -1, onClick: () => ge.value = n, children: n }, n)) }),
    N("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${ge.value}`, tabIndex: 0, children: N(e, {}) })
  ] });
}
function nc() {
  let e = Ju.value;
  return e ? Jt(wl, { children: [
    Jt("nav", { class: "chooser", "aria-label": "Selection", children: [
      N("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => kl("previous"), children: N(Jn, { name: "back" }) }),
      N("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => kl("next"), children: N(Jn, { name: "forth" }) }),
      N("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      N("span", { class: "gap" }),
      N("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: Qu, children: N(Jn, { name: "close" }) })
    ] }),
    ea.value && N("p", { class: "penless", children: ea.value }),
    Jt("fieldset", { class: "editing", disabled: ea.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && N(Zo, {}),
      e.kind === "thing" && N(vl, {}),
      e.kind === "material" && N(yl, {}),
      e.kind === "meter" && N(Ao, {}),
      e.kind === "grid" && N(qo, {})
    ] })
  ] }) : N(tc, {});
}

// src/later/sheets.tsx
import {
  allActions as aa,
  act as Tl,
  ask as dc,
  command as hc,
  copyText as fc,
  digits as gc,
  go as bc,
  hear as vc,
  lamps as yc,
  say as an,
  select as kc,
  send as tn,
  sheet as st,
  shown as wc,
  signal as ut,
  useEffect as oa,
  useLayoutEffect as xc,
  useRef as on,
  walkNames as Mc,
  whyNotTo as Sc
} from "./desk.js";

// src/later/csv.ts
import { gridPoint as ac, grids as oc, maintenance as lc, meters as rc, scene as xl } from "./desk.js";
var ic = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function sc() {
  let e = lc.peek(), t = [["scene", xl.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of rc.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of oc.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, l] of Object.entries(a)) t.push([o, l == null ? null : l * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, l) => {
      let r = ac(n, l % n.columns, Math.floor(l / n.columns));
      t.push([...r.map((s) => s.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(ic).join(",")).join(`\r
`) + `\r
`;
}
function ta(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function Ml() {
  let e = URL.createObjectURL(new Blob([sc()], { type: "text/csv" }));
  ta(`${xl.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var $l = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], en = new Uint8Array(512), na = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  en[e] = en[e + 255] = t, na[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var Sl = (e, t) => e && t ? en[na[e] + na[t]] : 0;
function uc(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let l = new Array(n.length + 1).fill(0);
    n.forEach((r, s) => {
      l[s] ^= r, l[s + 1] ^= Sl(r, en[o]);
    }), n = l;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let l = a[o];
    l && n.forEach((r, s) => a[o + s] ^= Sl(r, l));
  }
  return a.slice(e.length);
}
function cc(e, t) {
  let [n, a, o] = $l[t - 1], l = [], r = (b, d) => {
    for (let m = d - 1; m >= 0; m--) l.push(b >> m & 1);
  };
  for (r(4, 4), r(e.length, 8), e.forEach((b) => r(b, 8)), r(0, Math.min(4, n * 8 - l.length)); l.length % 8; ) l.push(0);
  let s = [];
  for (let b = 0; b < l.length; b += 8) s.push(parseInt(l.slice(b, b + 8).join(""), 2));
  for (let b = 236; s.length < n; b ^= 253) s.push(b);
  let c = n / o, i = Array.from({ length: o }, (b, d) => s.slice(d * c, (d + 1) * c)), p = i.map((b) => uc(b, a)), u = (b) => b[0].flatMap((d, m) => b.map((f) => f[m]));
  return [...u(i), ...u(p)];
}
var pc = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function mc(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function Cl(e) {
  let t = e.length, n = 0, a = 0;
  for (let o of [!1, !0])
    for (let l = 0; l < t; l++) {
      let r = Array.from({ length: t }, (i, p) => o ? e[p][l] : e[l][p]), s = 1;
      for (let i = 1; i <= t; i++)
        i < t && r[i] === r[i - 1] ? s++ : (s >= 5 && (n += s - 2), s = 1);
      let c = r.map(Number).join("");
      for (let i = 0; i + 11 <= t; i++) {
        let p = c.slice(i, i + 11);
        (p === "10111010000" || p === "00001011101") && (n += 40);
      }
    }
  for (let o = 0; o < t; o++)
    for (let l = 0; l < t; l++)
      e[o][l] && a++, l && o && e[o][l] === e[o - 1][l] && e[o][l] === e[o][l - 1] && e[o][l] === e[o - 1][l - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function Ll(e) {
  let t = [...new TextEncoder().encode(e)], n = $l.findIndex(([d]) => t.length + 2 <= d) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), l = Array.from({ length: a }, () => new Array(a).fill(!1)), r = (d, m, f) => {
    d < 0 || m < 0 || d >= a || m >= a || (o[m][d] = f, l[m][d] = !0);
  };
  for (let d = 0; d < a; d++)
    r(d, 6, d % 2 === 0), r(6, d, d % 2 === 0);
  for (let [d, m] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let f = -4; f <= 4; f++)
      for (let S = -4; S <= 4; S++) {
        let H = Math.max(Math.abs(S), Math.abs(f));
        r(d + S, m + f, H !== 2 && H !== 4);
      }
  if (n > 1) {
    let d = a - 7;
    for (let m = -2; m <= 2; m++) for (let f = -2; f <= 2; f++) r(d + f, d + m, Math.max(Math.abs(f), Math.abs(m)) !== 1);
  }
  let s = (d) => {
    let m = mc(d);
    for (let f = 0; f < 15; f++) {
      let S = (m >> f & 1) === 1, H = f < 6 ? f : f < 8 ? f + 1 : a - 15 + f;
      r(8, H, S), r(f < 8 ? a - 1 - f : f < 9 ? 7 : 14 - f, 8, S);
    }
    r(8, a - 8, !0);
  };
  s(0);
  let c = cc(t, n), i = 0;
  for (let d = a - 1; d > 0; d -= 2) {
    d === 6 && (d = 5);
    for (let m = 0; m < a; m++)
      for (let f of [d, d - 1]) {
        let H = (d + 1 & 2) === 0 ? a - 1 - m : m;
        l[H][f] || (o[H][f] = i < c.length * 8 && (c[i >> 3] >> 7 - (i & 7) & 1) === 1, i++);
      }
  }
  let p = (d) => (s(d), o.map((m, f) => m.map((S, H) => S !== (!l[f][H] && pc[d](H, f))))), u = p(0), b = Cl(u);
  for (let d = 1; d < 8; d++) {
    let m = p(d), f = Cl(m);
    f < b && ([u, b] = [m, f]);
  }
  return u;
}

// src/later/sheets.tsx
import { Fragment as qc, jsx as g, jsxs as P } from "./desk.js";
function ct({ title: e, wide: t, children: n }) {
  let a = on(null);
  xc(() => {
    let l = a.current, r = document.activeElement;
    return l.open || l.showModal(), () => r?.focus();
  }, []);
  let o = () => st.value = null;
  return g(
    "dialog",
    {
      ref: a,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: o,
      onClick: (l) => l.target === a.current && o(),
      children: P("div", { class: "sheet-body", children: [
        P("header", { children: [
          g("h2", { children: e }),
          g("span", { class: "gap" }),
          g("button", { onClick: o, children: "Close" })
        ] }),
        n
      ] })
    }
  );
}
var Cc = [
  ["Look around", "right or left drag", "arrows", "one finger"],
  ["Walk, up and down", "", "walking keys, Q E; Shift fast, Alt slow", "pad at the left"],
  ["Orbit about a point", "middle or Alt+left drag", "Shift+arrows", ""],
  ["Pan", "Shift+middle, Space+left drag", "Ctrl+arrows", "two fingers"],
  ["Nearer, farther", "wheel; Shift goes through", "+ −", "pinch"],
  ["Select; add; toggle", "click; Shift; Ctrl", "Tab in the list, [ ]", "tap"],
  ["Deeper: group, thing behind", "click again", "", "tap again"],
  ["Lux under the pointer", "hover", "P lays a meter", ""],
  ["What lights this", "right click", "Shift+P", "long press"],
  ["Level", "fader, wheel on it; Shift is fine", "digits Enter; arrows, Shift 10 %", "fader, two at once"],
  ["Default level", "double click on the fader", "", ""],
  ["Leave what is open", "", "Esc", ""]
];
function $c() {
  let e = [...new Set(aa().map((t) => t.group))];
  return g(ct, { title: "All keys", wide: !0, children: P("div", { class: "help", children: [
    P("table", { children: [
      g("caption", { class: "spoken", children: "By hand" }),
      g("thead", { children: P("tr", { children: [
        g("th", { scope: "col", children: "What" }),
        g("th", { scope: "col", children: "Mouse" }),
        g("th", { scope: "col", children: "Keys, in the view" }),
        g("th", { scope: "col", children: "Fingers" })
      ] }) }),
      g("tbody", { children: Cc.map(([t, n, a, o]) => P("tr", { children: [
        g("th", { scope: "row", children: t }),
        g("td", { children: n }),
        g("td", { children: a.replace("walking keys", Mc.value) }),
        g("td", { children: o })
      ] }, t)) })
    ] }),
    P("div", { class: "columns", children: [
      e.map((t) => P("section", { children: [
        g("h3", { children: t }),
        g("dl", { children: aa().filter((n) => n.group === t && n.keys).map((n) => P(qc, { children: [
          g("dt", { children: n.label }),
          g("dd", { children: g("kbd", { children: n.keys }) })
        ] })) })
      ] }, t)),
      P("section", { children: [
        g("h3", { children: "Numbers" }),
        P("dl", { children: [
          g("dt", { children: "Level" }),
          g("dd", { children: "80 %, 450 lm, *0.8, +10, -1/2 stop, full, out" }),
          g("dt", { children: "Colour" }),
          g("dd", { children: "2700K" }),
          g("dt", { children: "Length" }),
          g("dd", { children: `2.4m, 75cm, 8'2", +=0.1` }),
          g("dt", { children: "Angle" }),
          g("dd", { children: "30°" })
        ] })
      ] })
    ] })
  ] }) });
}
var nn = ut(""), it = ut(0);
function Lc() {
  let e = nn.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = aa().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: Sc(a.id), run: () => Tl(a.id) }));
  for (let { name: a, camera: o } of qt())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => bc(o, a) });
  if (e.length)
    for (let [a, o] of yc.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => kc("lamp", a) });
    }
  return n.slice(0, 60);
}
function Tc() {
  let e = Lc(), t = Math.min(it.value, e.length - 1);
  oa(() => {
    nn.value = "", it.value = 0;
  }, []), oa(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (st.value = null, a.why ? an(a.why, "warn") : setTimeout(a.run, 0));
  };
  return P(ct, { title: "Command palette", children: [
    g(
      "input",
      {
        type: "text",
        role: "combobox",
        class: "command",
        "aria-label": "Command",
        "aria-expanded": "true",
        "aria-controls": "commands",
        "aria-activedescendant": e.length ? `command-${t}` : void 0,
        "aria-autocomplete": "list",
        autofocus: !0,
        placeholder: "What shall be done?",
        value: nn.value,
        onInput: (a) => {
          nn.value = a.currentTarget.value, it.value = 0;
        },
        onKeyDown: (a) => {
          let o = { ArrowDown: 1, ArrowUp: -1 }[a.key];
          o && (a.preventDefault(), it.value = (t + o + e.length) % Math.max(1, e.length)), a.key === "Enter" && (a.preventDefault(), n(e[t]));
        }
      }
    ),
    P("ul", { class: "commands", id: "commands", role: "listbox", "aria-label": "Commands", children: [
      e.map((a, o) => P(
        "li",
        {
          id: `command-${o}`,
          role: "option",
          "aria-selected": o === t,
          "aria-disabled": a.why !== null,
          title: a.why ?? void 0,
          onPointerMove: () => it.value = o,
          onClick: () => n(a),
          children: [
            g("span", { children: a.label }),
            g("kbd", { children: a.note })
          ]
        },
        a.label + o
      )),
      !e.length && g("li", { class: "quiet", role: "option", "aria-selected": "false", "aria-disabled": "true", children: "Nothing is called so." })
    ] })
  ] });
}
var Pl = ut([]);
vc("links", (e) => Pl.value = e.links);
function Pc({ text: e }) {
  let t = Ll(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, l) => o.map((r, s) => r ? `M${s + 4} ${l + 4}h1v1h-1z` : "").join("")).join("");
  return P("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    g("rect", { width: n, height: n, fill: "#fff" }),
    g("path", { d: a, fill: "#000" })
  ] });
}
function Ec() {
  let e = ut(null), t = on(e).current;
  return oa(() => {
    tn({ do: "links", what: "list" });
  }, []), P(ct, { title: "Share by link", children: [
    g("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    g("ul", { class: "links", children: Pl.value.map((n) => P("li", { children: [
      g("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      g("code", { children: n.address }),
      P("span", { class: "buttons", children: [
        g("button", { onClick: () => {
          fc(n.address);
        }, children: "Copy" }),
        g("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        g("button", { onClick: () => tn({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && g(Pc, { text: n.address })
    ] }, n.id)) }),
    P("footer", { children: [
      g("button", { onClick: () => tn({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      g("button", { onClick: () => tn({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function Vc() {
  let e = on(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    hc({ do: "save", name: n }), st.value = null, an(`Saving the version “${n}”.`);
  };
  return P(ct, { title: "Save a version", children: [
    g("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    P("label", { class: "line", children: [
      g("span", { children: "Name" }),
      g("span", { class: "field", children: g("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    g("footer", { children: g("button", { onClick: t, children: "Save" }) })
  ] });
}
var ne = ut(null);
function Ic() {
  let e = wc.value?.head, t = on(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    ne.value = 0;
    let [o, l] = [Number(n("width")), Number(n("height"))];
    dc("picture", { format: n("format"), width: o, height: l, batches: Number(n("batches")) }, (r) => {
      r.why ? (ne.value = null, an(r.why, "warn")) : r.url ? (ne.value = null, ta(r.name, r.url), st.value = null) : ne.value = r.progress ?? 0;
    }, (r) => {
      ne.value = null, an(r, "warn");
    });
  };
  return P(ct, { title: "Save the picture", children: [
    P("div", { ref: t, class: "form", children: [
      P("label", { class: "line", children: [
        g("span", { children: "Format" }),
        P("select", { name: "format", children: [
          g("option", { value: "png", children: "PNG, as it is shown" }),
          g("option", { value: "exr", children: "EXR, the light itself" })
        ] })
      ] }),
      P("label", { class: "line", children: [
        g("span", { children: "Width" }),
        g("input", { type: "number", name: "width", min: 16, max: 16384, value: Math.max(e?.width ?? 0, 640) })
      ] }),
      P("label", { class: "line", children: [
        g("span", { children: "Height" }),
        g("input", { type: "number", name: "height", min: 16, max: 16384, value: Math.max(e?.height ?? 0, 480) })
      ] }),
      P("label", { class: "line", children: [
        g("span", { children: "Batches" }),
        g("input", { type: "number", name: "batches", min: 1, max: 1e5, value: 64 })
      ] })
    ] }),
    ne.value !== null && g("progress", { max: 1, value: ne.value, "aria-label": "Rendering" }),
    P("footer", { children: [
      g("button", { onClick: () => Tl("command"), children: "Copy the command" }),
      g("button", { disabled: ne.value !== null, onClick: a, children: ne.value === null ? "Render and save" : ne.value ? `${gc(ne.value * 100)} %` : "Rendering…" })
    ] })
  ] });
}
function Ac() {
  switch (st.value) {
    case "help":
      return g($c, {});
    case "palette":
      return g(Tc, {});
    case "share":
      return g(Ec, {});
    case "save":
      return g(Vc, {});
    case "picture":
      return g(Ic, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import { act as Rc, colorText as El, cost as Fc, css as Hc, LevelField as Nc, listed as Dc, pickRow as Gc, Power as Oc, select as Wc, three as Kc } from "./desk.js";
import { jsx as J, jsxs as la } from "./desk.js";
function Bc() {
  return la("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    J("span", {}),
    J("span", { children: "Name" }),
    J("span", { children: "Level" }),
    J("span", { children: "lm" }),
    J("span", { children: "White" })
  ] });
}
function Uc({ row: e, index: t, count: n }) {
  let a = Dc(e, t, n);
  if (!a) return null;
  let { lamp: o, entry: l } = a;
  return la("div", { class: `sheet-row ${a.state}`, ...a.frame, children: [
    J(Oc, { of: a }),
    J("button", { class: "row-name", "aria-pressed": a.selected, title: o ? Fc(o) : void 0, onClick: (r) => Gc(r, e.kind, e.id), onDblClick: () => Rc("frame"), children: J("span", { children: l.name }) }),
    J(Nc, { of: a, label: "level" }),
    J("span", { class: "lumens", children: Kc(a.lumens) }),
    o ? la("button", { class: "tint", "aria-label": `${l.name} colour: ${El(o)}`, onClick: () => Wc("lamp", e.id), children: [
      J("i", { class: "swatch", style: { background: Hc(o.swatch) } }),
      El(o)
    ] }) : J("span", {})
  ] });
}

// src/later/strip.tsx
import {
  act as ra,
  command as Hl,
  digits as ia,
  display as _c,
  fade as ln,
  Field as Nl,
  grids as Vl,
  Icon as Ke,
  looks as Il,
  luxText as Al,
  maintained as We,
  maintenance as Xc,
  meters as ql,
  select as Rl,
  selection as rn,
  show as Yc,
  signal as zc,
  signed as jc,
  storeLook as Zc
} from "./desk.js";
import { Fragment as np, jsx as x, jsxs as F } from "./desk.js";
var sa = zc("looks");
function Qc() {
  return F("section", { class: "looks", "aria-label": "Looks", children: [
    F("header", { children: [
      x("h2", { children: "Looks" }),
      x("button", { class: "tab", onClick: () => sa.value = "meters", children: "Meters" }),
      x("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: Zc, children: x(Ke, { name: "plus" }) }),
      x("span", { class: "gap" }),
      F("label", { class: "tint", children: [
        "Fade",
        x(Nl, { label: "Cross-fade", quantity: "seconds", value: ln.value, step: 0.5, set: (e) => ln.value = Math.max(0, e(ln.value)) })
      ] })
    ] }),
    F("ul", { children: [
      Il.all().map(([e, t], n) => F("li", { class: "look", children: [
        F("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Hl({ do: "look", id: e, what: "recall", seconds: ln.peek() }), children: [
          t.picture && x("img", { src: t.picture, alt: t.name, width: 96, height: 72 }),
          x("span", { "aria-hidden": t.picture ? "true" : void 0, children: t.name })
        ] }),
        x(Jc, { id: e, name: t.name })
      ] }, e)),
      !Il.ids.value.length && x("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function Jc({ id: e, name: t }) {
  let n = `look-${e}`, a = (c) => {
    let i = c.getBoundingClientRect(), p = document.getElementById(n);
    p?.style.setProperty("left", `${Math.min(i.left, innerWidth - 296)}px`), p?.style.setProperty("bottom", `${innerHeight - i.top + 4}px`), p?.style.setProperty("top", "auto");
  }, o = _c.value.false_color?.against === e, l = { popovertarget: n }, r = () => document.getElementById(n)?.hidePopover(), s = (c, i = {}) => {
    r(), Hl({ do: "look", id: e, what: c, ...i });
  };
  return F(np, { children: [
    x("button", { class: "icon more", ...l, "aria-label": `More of ${t}`, onPointerDown: (c) => a(c.currentTarget), onFocus: (c) => a(c.currentTarget), children: x(Ke, { name: "more" }) }),
    F("div", { id: n, popover: "auto", class: "menu", children: [
      F("label", { class: "line", children: [
        x("span", { children: "Name" }),
        x("span", { class: "field", children: x("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (c) => s("rename", { name: c.currentTarget.value }) }) })
      ] }),
      x("button", { class: "item", onClick: () => s("update"), children: x("span", { children: "Update to what is set now" }) }),
      x("button", { class: "item", onClick: () => s("recall", { seconds: 0 }), children: x("span", { children: "Recall at once" }) }),
      x(
        "button",
        {
          class: "item",
          onClick: () => {
            r(), Yc({ false_color: o ? null : ft(e) });
          },
          children: x("span", { children: o ? "End the difference" : "Difference to now" })
        }
      ),
      x("button", { class: "item", onClick: () => s("remove"), children: x("span", { children: "Remove" }) })
    ] })
  ] });
}
var Fl = (e, t) => e == null ? "" : ` · Δ ${jc(e * t)}`;
function ep() {
  let e = Xc.value;
  return F("section", { class: "readings", "aria-label": "Meters and grids", children: [
    F("header", { children: [
      x("h2", { children: "Meters" }),
      x("button", { class: "tab", onClick: () => sa.value = "looks", children: "Looks" }),
      x("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => ra("meter-tool"), children: x(Ke, { name: "meter" }) }),
      x("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => ra("grid"), children: x(Ke, { name: "grid" }) }),
      x("button", { onClick: () => ra("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      F("label", { class: "tint", title: "How high levels may be set, of each lamp's flux", children: [
        "up to",
        x(Nl, { label: "Highest level to reach targets", quantity: "level", value: Ie.value, step: 0.1, set: (t) => Ie.value = Math.min(10, Math.max(1, t(Ie.value))) })
      ] }),
      x("button", { onClick: Ml, title: "Save all figures as CSV", children: "CSV" }),
      x("span", { class: "gap" }),
      x("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${ia(e, 2)} maintained` })
    ] }),
    F("ul", { children: [
      ql.all().map(([t, n]) => {
        let a = n.lux;
        return x("li", { children: F("button", { class: "reading", "aria-pressed": rn.value?.kind === "meter" && rn.value.ids.includes(t), onClick: () => Rl("meter", t), children: [
          F("span", { class: "tint", children: [
            x(Ke, { name: "meter" }),
            n.name,
            " ",
            x(qn, { of: Ht(n) })
          ] }),
          x("strong", { class: Rt(n) ? "unsettled" : "", children: a ? We(a[0]) : "…" }),
          F("small", { children: [
            a?.[1] != null ? `±${We(a[1], !1)}` : "measuring",
            " ",
            n.kind,
            Fl(n.change, e),
            n.target ? ` · wants ${Al(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      Vl.all().map(([t, n]) => {
        let a = n.target;
        return x("li", { children: F("button", { class: "reading", "aria-pressed": rn.value?.kind === "grid" && rn.value.ids.includes(t), onClick: () => Rl("grid", t), children: [
          F("span", { class: "tint", children: [
            x(Ke, { name: "grid" }),
            n.name,
            " ",
            x(qn, { of: Nt(n) })
          ] }),
          x("strong", { class: Ft(n) ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${We(n.mean)}${n.error == null ? "" : ` ±${We(n.error, !1)}`}` }),
          F("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : ia(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : We(n.min, !1),
            " to",
            " ",
            n.max == null ? "…" : We(n.max, !1),
            Fl(n.change, e),
            a ? ` · wants ${Al(a.lux)}, U₀ ${ia(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !ql.ids.value.length && !Vl.ids.value.length && x("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function tp() {
  return F("div", { class: "strip-parts", "data-tab": sa.value, children: [
    x(Qc, {}),
    x(ep, {})
  ] });
}

// src/later/menus.tsx
import {
  camera as Ol,
  digits as Wl,
  display as ap,
  Field as un,
  go as Kl,
  houseLights as ua,
  Item as Te,
  Range as op,
  show as ca,
  theme as Dl,
  walking as lp
} from "./desk.js";
import { Fragment as cn, jsx as $, jsxs as ae } from "./desk.js";
var sn = Math.PI / 360;
function Gl(e) {
  let t = Ol.peek();
  t && Kl({ ...t, fov: Math.max(3, Math.min(140, e)) });
}
function rp() {
  let e = Ol.value, t = qt();
  return ae(cn, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((n) => $(Te, { id: n }, n)),
    $("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((n) => $(Te, { id: `preset-${n}` }, n)),
    $("hr", {}),
    t.length > 0 && $("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    t.map(({ name: n, camera: a }, o) => $("button", { class: "item", onClick: () => Kl(a, n), children: $("span", { children: n }) }, o)),
    t.length > 0 && $("hr", {}),
    e && !e.height && ae(cn, { children: [
      ae("label", { class: "line", children: [
        $("span", { children: "Angle" }),
        $(un, { label: "Vertical angle of view", quantity: "angle", value: e.fov, step: 1, set: (n) => Gl(n(e.fov)) })
      ] }),
      ae("label", { class: "line", children: [
        $("span", { children: "Focal length" }),
        $(un, { label: "Focal length on 36 × 24 mm", quantity: "number", value: Math.round(120 / Math.tan(e.fov * sn)) / 10, text: `${Wl(12 / Math.tan(e.fov * sn), 1)} mm`, step: 1, set: (n) => Gl(Math.atan(12 / Math.max(2, n(12 / Math.tan(e.fov * sn)))) / sn) })
      ] }),
      $("hr", {})
    ] }),
    $(Te, { id: "walking", label: lp.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    $(Te, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((n) => $(Te, { id: `hands-${n}` }, n))
  ] });
}
var ip = ["linear", "reinhard", "filmic"];
function sp() {
  let e = ap.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return ae(cn, { children: [
    ae("fieldset", { children: [
      $("legend", { children: "Tone curve" }),
      $("div", { class: "segments", children: ip.map((n) => $("button", { "aria-pressed": e.tone === n, onClick: () => ca({ tone: n }), children: n }, n)) })
    ] }),
    ae("fieldset", { children: [
      $("legend", { children: "White balance" }),
      ae("label", { class: "line", children: [
        $("span", { children: "White" }),
        $(un, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => ca({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      ae("label", { class: "line", children: [
        $("span", { children: "Tint" }),
        $(un, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => ca({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    $("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "clamped", "units", "marks", "fine", "picture", "command"].map((n) => $(Te, { id: n }, n))
  ] });
}
function up() {
  return ae(cn, { children: [
    ae("label", { class: "line", children: [
      $("span", { children: "House lights" }),
      $(op, { label: "House lights", value: ua.value, text: `${Wl(ua.value * 100)} %`, on: (e) => ua.value = Math.max(0.3, e) })
    ] }),
    $("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => $("button", { "aria-pressed": Dl.value === e, onClick: () => Dl.value = e, children: e }, e)) }),
    $("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => $(Te, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as pn, cut as cp, digits as Bl, edit as Ul, go as pp, Icon as pt, Range as mp, setCut as dp, signal as hp, storeView as fp, viewName as gp, views as bp } from "./desk.js";
import { jsx as W, jsxs as pa } from "./desk.js";
var mn = hp(null);
function vp() {
  let e = bp.all();
  return pa("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    W("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => pn("home"), children: W(pt, { name: "home" }) }),
    W("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => pn("frame"), children: W(pt, { name: "frame" }) }),
    W("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => pn("back"), children: W(pt, { name: "back" }) }),
    W("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => pn("forth"), children: W(pt, { name: "forth" }) }),
    W("span", { class: "divide" }),
    e.map(([t, n], a) => mn.value === t ? W("span", { class: "field", children: W(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (o) => o?.focus(),
        onBlur: (o) => {
          let l = o.currentTarget.value.trim();
          mn.value = null, l && l !== n.name && Ul(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (o) => {
          o.stopPropagation(), o.key === "Escape" && (o.currentTarget.value = n.name ?? ""), (o.key === "Enter" || o.key === "Escape") && o.currentTarget.blur();
        }
      }
    ) }, t) : pa(
      "button",
      {
        class: "saved-view",
        "aria-pressed": gp.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click or F2 renames, Delete removes`,
        onClick: () => pp(n, n.name ?? "view"),
        onDblClick: () => mn.value = t,
        onKeyDown: (o) => {
          o.key === "F2" && (mn.value = t), o.key === "Delete" && (o.stopPropagation(), Ul(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          W("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    W("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: fp, children: W(pt, { name: "plus" }) })
  ] });
}
function yp() {
  let e = cp.value;
  if (!e) return null;
  let t = e.height === null ? `${Bl(e.value, 2)} m` : `at ${Bl(e.height, 2)} m`;
  return pa("label", { class: "cut", "data-scroll": !0, children: [
    W("span", { children: "Cut" }),
    W(
      mp,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => dp(n * e.most)
      }
    ),
    W("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as kp, useRef as wp } from "./desk.js";
import { jsx as _l } from "./desk.js";
function xp() {
  let e = wp(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let l = a.getBoundingClientRect(), r = (i) => Math.max(-1, Math.min(1, i)), s = o ? 0 : r((n.clientX - l.left) / (l.width / 2) - 1), c = o ? 0 : r(1 - (n.clientY - l.top) / (l.height / 2));
    e.current?.style.setProperty("transform", `translate(${s * 28}px, ${-c * 28}px)`), kp(c, s);
  };
  return _l("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: _l("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as Xl,
  closeWhat as Yl,
  digits as Mp,
  hovered as zl,
  Icon as Sp,
  lamps as Cp,
  maintained as be,
  nameOf as $p,
  select as Lp,
  useEffect as Tp,
  useRef as Pp,
  viewSize as Ep,
  what as Vp
} from "./desk.js";
import { jsx as U, jsxs as le } from "./desk.js";
var Pe = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], Ip = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function Ap() {
  let e = Vp.value, t = Pp(null);
  if (Tp(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = Ep.value, o = [...e.lamps].sort((u, b) => Pe(b) - Pe(u)), l = o.reduce((u, b) => u + Pe(b), 0) || 1, r = o.slice(0, 9), s = l - r.reduce((u, b) => u + Pe(b), 0), c = Math.max(8, Math.min(e.x + 12, n - 332)), i = Math.max(8, Math.min(e.y + 12, a - 150 - 35 * r.length)), p = e.lux ? `${be(e.lux[0])} ±${be(e.lux[1], !1)}` : "Measuring…";
  return le(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${c}px`, top: `${i}px` },
      onKeyDown: (u) => {
        u.key === "Escape" && (u.stopPropagation(), Yl(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        le("header", { children: [
          U("strong", { class: e.done ? "" : "unsettled", children: p }),
          U("span", { class: "quiet", children: "what lights this" }),
          U("button", { class: "icon", "aria-label": "Close", onClick: Yl, children: U(Sp, { name: "close" }) })
        ] }),
        le("ol", { children: [
          r.map((u) => U(
            "li",
            {
              onPointerEnter: () => zl.value = { kind: "lamp", id: u.id },
              onPointerLeave: () => zl.value = null,
              children: le("button", { class: "row", onClick: () => Lp("lamp", u.id), children: [
                U("span", { class: "name", children: $p("lamp", u.id) }),
                le("span", { class: "figure", children: [
                  Mp(100 * Pe(u) / l, Pe(u) / l < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                le("span", { class: "figure lux", children: [
                  be(Pe(u)),
                  " ±",
                  be(Ip(u), !1)
                ] }),
                le("span", { class: "shares", "aria-hidden": "true", children: [
                  U("i", { class: "direct", style: { width: `${100 * u.direct[0] / l}%` } }),
                  U("i", { class: "indirect", style: { width: `${100 * u.indirect[0] / l}%` } }),
                  U("i", { class: "caustic", style: { width: `${100 * u.caustic[0] / l}%` } })
                ] }),
                le("span", { class: "spoken", children: [
                  "direct ",
                  be(u.direct[0]),
                  ", indirect ",
                  be(u.indirect[0]),
                  ", caustic",
                  " ",
                  be(u.caustic[0])
                ] })
              ] })
            },
            u.id
          )),
          o.length > r.length && le("li", { class: "quiet", children: [
            o.length - r.length === 1 ? "one more" : `${o.length - r.length} more together`,
            ": ",
            be(s)
          ] }),
          !o.length && U("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        le("footer", { children: [
          U("span", { class: "key direct", children: "direct" }),
          U("span", { class: "key indirect", children: "indirect" }),
          U("span", { class: "key caustic", children: "caustic" }),
          U("span", { class: "gap" }),
          Xl.value.some((u) => Cp.get(u)?.place?.direction) && U("button", { onClick: () => ze(Xl.peek(), e.hit.point), children: "Aim here" }),
          U("button", { onClick: () => Ze(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Ws as Compare,
  yp as CutBar,
  Ci as Gizmo,
  nc as Inspector,
  rr as Legend,
  up as PageItems,
  sp as SeeingItems,
  Bc as SheetHead,
  Uc as SheetRow,
  Ac as Sheets,
  tp as Strip,
  Ki as TypedHint,
  rp as ViewItems,
  vp as ViewStrip,
  xp as WalkPad,
  Ap as What
};
