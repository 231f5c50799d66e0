// src/later/actions.ts
import {
  adding as hl,
  asked as gl,
  ask as fl,
  back as bl,
  candles as oa,
  chosenLamps as pe,
  clearSolo as vl,
  command as nn,
  compareHeld as yl,
  copyText as kl,
  DEFAULT_FALSE as wl,
  deselect as xl,
  each as ln,
  edit as rn,
  exposeBy as la,
  falseColor as Ml,
  fine as ra,
  forth as Sl,
  frameSelection as Cl,
  go as $l,
  goHome as Ll,
  goInside as Pl,
  goPreset as Tl,
  handles as ia,
  hands as El,
  here as Vl,
  highlight as Al,
  history as sa,
  lampMarks as ua,
  lamps as ft,
  listing as ca,
  lookOnly as pa,
  looks as Il,
  panels as ma,
  PRESETS as ql,
  register as Rl,
  say as Ze,
  scene as Fl,
  selection as va,
  send as Hl,
  sheet as Qe,
  show as an,
  soloSelection as Nl,
  spot as Ye,
  startTool as ke,
  stepSelection as da,
  storeLook as Dl,
  storeView as Ol,
  theme as ha,
  things as ga,
  titleOf as ya,
  toggleFalse as Wl,
  toggleWipe as Gl,
  travel as fa,
  views as Kl,
  walking as on,
  whyNot as Q
} from "./desk.js";

// src/later/differ.ts
var ct = (e) => ({
  quantity: "difference",
  against: e,
  low: -500,
  high: 500,
  scale: "linear",
  palette: "diverging",
  lines: !1
});
function Qn(e) {
  let t = Math.min(1e6, Math.max(0.01, e.high));
  return { ...e, low: -t, high: t, scale: "linear" };
}

// src/later/most.ts
import { signal as nl } from "./desk.js";
var $e = nl(1);

// src/later/tools.ts
import {
  add as Le,
  adding as al,
  chosenLamps as Yn,
  cross as ol,
  distance as ll,
  dot as Yt,
  edit as pt,
  effect as rl,
  free as ta,
  grids as Zn,
  lamps as Pe,
  meters as Jn,
  normal as Zt,
  onTool as il,
  positionOf as sl,
  say as mt,
  scale as ce,
  select as ul,
  step as Jt,
  sub as dt,
  titleOf as ht,
  tool as ye,
  up as na
} from "./desk.js";
var Ue = null;
rl(() => {
  ye.value !== "grid" && (Ue = null);
});
function cl(e) {
  if (!e) return mt("There is nothing at that point.", "warn");
  switch (ye.peek()) {
    case "aim":
      _e(Yn.peek(), e.point), ye.value = null;
      break;
    case "place":
      pl(Yn.peek(), e), ye.value = null;
      break;
    case "meter":
      je(e.point, e.normal), ye.value = null;
      break;
    case "grid":
      if (!Ue) {
        Ue = e;
        return;
      }
      ml(Ue.point, e.point), Ue = null, ye.value = null;
      break;
    case "add":
      dl(al.peek(), e), ye.value = null;
      break;
  }
}
il(cl);
function _e(e, t) {
  let n = {};
  for (let a of e) {
    let o = Pe.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: Zt(dt(t, o.position)) } });
  }
  if (!Object.keys(n).length) return mt("What is selected shines into all directions: it cannot be aimed.", "warn");
  pt(`Aim ${ht(e)}`, { lamps: n });
}
function en(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let r = o.filter((l) => !n.has(l));
    r.length && (ul(t, r[r.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), 3e3);
}
function pl(e, t) {
  let n = Xe(e), a = n.get(e[e.length - 1]);
  if (!a) return mt("What is selected has no place.", "warn");
  let o = (Pe.get(e[e.length - 1])?.place?.radius ?? 0) + 0.02;
  pt(`Put ${ht(e)} on a surface`, ze(e, dt(Le(t.point, ce(t.normal, o)), a), n));
}
function je(e, t) {
  let n = ta(Jn);
  en(Jn, "meter"), pt("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function tn(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
function ml(e, t, n = { lux: 500, uniformity: 0.6 }) {
  let a = na.peek(), o = Math.abs(a[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], r = Zt(ol(a, o)), l = dt(t, e), [i, u] = [Yt(l, o), Yt(l, r)];
  if (Math.abs(i) < 0.05 || Math.abs(u) < 0.05) return mt("An area needs two corners that lie apart.", "warn");
  let s = Le(e, Le(ce(o, Math.min(i, 0)), ce(r, Math.min(u, 0))));
  [i, u] = [Math.abs(i), Math.abs(u)];
  let m = (b) => Math.max(1, Math.ceil(b / tn(Math.max(i, u)))), p = ta(Zn);
  en(Zn, "grid"), pt("Lay a grid", {
    grids: {
      [p]: {
        name: `Area ${p + 1}`,
        corner: s,
        u: ce(o, i),
        v: ce(r, u),
        normal: a,
        columns: m(i),
        rows: m(u),
        target: n
      }
    }
  });
}
var ea = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function dl(e, t) {
  let n = na.peek(), a = Yt(t.normal, n), o = a > 0.7 ? Le(t.point, ce(n, 1.2)) : Le(t.point, ce(t.normal, 0.15)), r = a > 0.7 || a < -0.7 ? ce(n, -1) : t.normal, l = { position: o };
  e !== "point" && e !== "sphere" && (l.direction = r), e === "spot" && Object.assign(l, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (l.radius = 0.15), e === "sphere" && (l.radius = 0.08);
  let i = Pe.all().filter(([, u]) => u.own).length;
  en(Pe, "lamp"), Jt(`Add ${ea[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${ea[e] ?? e} ${i + 1}`, kind: e, flux: 800, place: l }
  });
}
function gt(e, t, n) {
  !e.length || t < 1 || Jt(`Copy ${ht(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function aa(e) {
  e.length && Jt(`Remove ${ht(e)}`, { do: "remove", lamps: e });
}
function ze(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = Pe.get(o)?.place, l = n.get(o);
    if (!l) continue;
    let i = Le(l, t), u = r?.aim && ll(r.aim, i) > 1e-6 ? { direction: Zt(dt(r.aim, i)) } : {};
    a[o] = { place: { position: i, ...u } };
  }
  return { lamps: a };
}
function Xe(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = Pe.get(n), o = a && sl(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/actions.ts
var oe = () => Q() ?? (pe.value.length ? null : "Select a lamp first.");
function Bl() {
  let e = pe.peek(), t = !e.some((n) => ft.get(n)?.on);
  rn(`${ya(e)} ${t ? "on" : "off"}`, { lamps: ln(e, { on: t }) });
}
function Ul() {
  let e = pe.peek(), t = !e.every((n) => ft.get(n)?.parked);
  rn(`${t ? "Park" : "Unpark"} ${ya(e)}`, { lamps: ln(e, { parked: t }) });
}
function ba(e) {
  let t = va.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : ga.ids.peek().filter((a) => ga.get(a)?.hidden);
  if (!n.length) return Ze(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  rn(e ? "Hide things" : "Show hidden things", { things: ln(n, { hidden: e }) });
}
function _l() {
  let e = pe.peek()[0], t = ft.get(e)?.place, n = Vl();
  if (!t?.position || !t.direction || !n) return Ze("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  $l({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function jl() {
  fl("command", {}, (e) => {
    kl(e.text);
  });
}
var zl = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Xl = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, Ql = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: Cl },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: Ll },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: Pl },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: bl },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: Sl },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Ol, why: Q },
  ...ql.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Xl[e],
    keys: `Shift+${t + 1}`,
    run: () => Tl(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      on.value = on.peek() === "walk" ? "fly" : "walk", Ze(on.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: _l, why: oe },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => da(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => da(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => ke("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => va.value = { kind: "lamp", ids: ft.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: xl },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: Bl, why: oe },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Nl, why: () => pe.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: vl },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => Al(!0), why: oe },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Ul, why: oe },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => ke("aim"), why: oe },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => Ye.peek() && _e(pe.peek(), Ye.peek().point), why: oe },
  { id: "place", group: "Lamps", label: "Put on a surface by pointing", keys: "Shift+N", run: () => ke("place"), why: oe },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => ia.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => ia.value = "turn" },
  ...zl.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: Q,
    run: () => {
      hl.value = e, ke("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => gt(pe.peek(), 1, [0.5, 0, 0]), why: oe },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => aa(pe.peek()), why: oe },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => ba(!0), why: Q },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => ba(!1), why: Q },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => nn({ do: "undo" }), why: () => Q() ?? (sa.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => nn({ do: "redo" }), why: () => Q() ?? (sa.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => Qe.value = "save", why: Q },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => Qe.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: jl },
  { id: "share", group: "Work", label: "Share by link", run: () => Qe.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: Wl },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = Ml();
      e.against != null ? an({ false_color: wl }) : an({ false_color: { ...gl(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  {
    id: "difference",
    group: "Seeing",
    label: "Difference in lux to the look stored last",
    run: () => {
      let e = Il.ids.peek().at(-1);
      e === void 0 ? Ze("Store a look first.") : an({ false_color: ct(e) });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => la(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => la(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => Hl({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => yl(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: Gl },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: Q, run: () => Ye.peek() ? je(Ye.peek().point, Ye.peek().normal) : ke("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => ke("meter"), why: Q },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => ke("grid"), why: Q },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => nn({ do: "reach", most: $e.peek() }), why: Q },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => oa.value = oa.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Dl, why: Q },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => Ze("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => ma.value = !ma.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => ca.value = ca.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => fa.value = fa.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => ua.value = !ua.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => ra.value = !ra.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => ha.value = ha.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => pa.value = !pa.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => El.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => Qe.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => Qe.value = "palette" }
];
Rl(Ql);
function bt() {
  return [...(Fl.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...Kl.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as Yl, comparing as Zl, digits as Jl, fitted as er, useEffect as tr, useRef as nr, viewSize as ar, wipeAt as sn } from "./desk.js";
import { Fragment as lr, jsx as un, jsxs as rr } from "./desk.js";
function or() {
  let e = Zl.value, t = Yl.value, n = nr(null);
  if (tr(() => {
    let s = n.current;
    !s || !t || (s.width = t.picture.width, s.height = t.picture.height, s.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = ar.value, o = sn.value, r = er(t.picture.width, t.picture.height), l = Math.max(0, Math.min(1, (o * a - r.x) / (t.picture.width * r.scale))), i = (s) => {
    let m = s.currentTarget;
    if (s.stopPropagation(), s.type === "pointerdown") m.setPointerCapture(s.pointerId);
    else if (m.hasPointerCapture(s.pointerId)) {
      let p = m.parentElement.getBoundingClientRect();
      sn.value = Math.max(0, Math.min(1, (s.clientX - p.left) / p.width));
    }
  }, u = (s) => {
    let m = { ArrowLeft: -0.02, ArrowRight: 0.02 }[s.key];
    m && (s.stopPropagation(), s.preventDefault(), sn.value = Math.max(0, Math.min(1, o + m)));
  };
  return rr(lr, { children: [
    un(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * l}% 0 0)` : "none" }
      }
    ),
    un("span", { class: "tag left", children: "before" }),
    e === "wipe" && un(
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
        "aria-valuetext": `${Jl(o * 100)} % before`,
        style: { left: `${100 * o}%` },
        onPointerDown: i,
        onPointerMove: i,
        onKeyDown: u
      }
    )
  ] });
}

// src/later/handles.tsx
import {
  add as Ca,
  chosenLamps as gr,
  computed as mn,
  editor as fr,
  effect as br,
  fitted as vr,
  Gesture as yr,
  handles as kr,
  lamps as yt,
  lookOnly as wr,
  middle as xr,
  nameOf as Mr,
  normal as Sr,
  pinhole as Cr,
  positionOf as La,
  role as $r,
  selection as Lr,
  shown as Pr,
  sub as Tr,
  things as kt,
  titleOf as Er,
  tool as Vr,
  turn as $a,
  useEffect as Ar,
  useRef as Ir,
  viewSize as qr
} from "./desk.js";

// src/later/gizmo.ts
import { project as ka, ray as ir } from "./desk.js";
import { across as sr, add as le, cross as ur, distance as cr, dot as me, length as pr, normal as cn, scale as re, sub as Te } from "./desk.js";
var mr = "http://www.w3.org/2000/svg", pn = 84, we = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], vt = ["x", "y", "z"], wa = 0.1, dr = 5 * Math.PI / 180, xa = 48;
function Sa(e, t) {
  let n = (d, f, k) => {
    let w = document.createElementNS(mr, d);
    return w.setAttribute("class", k), f.append(w), w;
  }, a = (d, f, k) => {
    let w = n("g", e, `handle ${d} ${vt[f] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), r = we.map((d, f) => a("ring", f, `ring-${vt[f]}`)), l = we.map((d, f) => a("plane", f, `plane-${vt[f]}`)), i = we.map((d, f) => a("arrow", f, `move-${vt[f]}`)), u = a("centre", -1, "move-view"), s = a("aim", -1, "aim"), m = n("text", e, "handle-text"), p = (d, f) => {
    let [k, w, T] = ka(d.hole, f);
    return T < 0.02 && !d.hole.parallel ? null : [d.fit.x + k * d.fit.scale, d.fit.y + w * d.fit.scale];
  }, b = (d, f) => {
    let k = ka(d.hole, f)[2];
    return pn / d.fit.scale * d.hole.pixel * (d.hole.parallel ? 1 : Math.max(k, 0.02));
  }, c = (d, f, k = !1) => {
    let w = f.filter((C) => C !== null), T = w.length < f.length || w.length < 2 ? "" : `M${w.map((C) => `${C[0].toFixed(1)} ${C[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    d.setAttribute("d", T);
  }, g = (d, f, k) => {
    d.setAttribute("d", f ? `M${f[0] - k} ${f[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, v = (d, f) => d.forEach((k) => k.group.classList.toggle("gone", !f));
  function V(d, f) {
    let k = d.position, w = p(f, k), T = b(f, k), C = d.mode === "move";
    v([...i, ...l, u], C && w !== null), v(r, !C && w !== null && d.turns);
    let z = d.aim ?? (d.direction ? le(k, re(d.direction, 3 * T)) : null);
    if (v([s], z !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    we.forEach((O, U) => {
      let q = p(f, le(k, re(O, T))), it = q ? Math.hypot(q[0] - w[0], q[1] - w[1]) < 12 : !0;
      if (i[U].group.classList.toggle("gone", !C || it), q && C) {
        let [ve, Ke] = [(q[0] - w[0]) / pn, (q[1] - w[1]) / pn], ut = Math.hypot(ve, Ke) || 1, [ue, Be] = [ve / ut, Ke / ut], Qt = [w[0] + 14 * ue, w[1] + 14 * Be];
        c(i[U].hit, [Qt, q]), i[U].seen.setAttribute("d", `M${Qt[0].toFixed(1)} ${Qt[1].toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}M${(q[0] - 9 * ue - 4.5 * Be).toFixed(1)} ${(q[1] - 9 * Be + 4.5 * ue).toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}L${(q[0] - 9 * ue + 4.5 * Be).toFixed(1)} ${(q[1] - 9 * Be - 4.5 * ue).toFixed(1)}`);
      }
      let [We, Ge] = [we[(U + 1) % 3], we[(U + 2) % 3]], Z = Math.abs(me(O, f.hole.parallel ? f.hole.forward : cn(Te(k, f.hole.eye)))) < 0.15;
      l[U].group.classList.toggle("gone", !C || Z);
      let st = (ve, Ke) => p(f, le(k, le(re(We, ve * T), re(Ge, Ke * T)))), Xn = [st(0.3, 0.3), st(0.5, 0.3), st(0.5, 0.5), st(0.3, 0.5)];
      if (c(l[U].hit, Xn, !0), c(l[U].seen, Xn, !0), !C) {
        let ve = Array.from({ length: xa + 1 }, (Ke, ut) => {
          let ue = 2 * Math.PI * ut / xa;
          return p(f, le(k, le(re(We, Math.cos(ue) * T), re(Ge, Math.sin(ue) * T))));
        });
        c(r[U].hit, ve), c(r[U].seen, ve);
      }
    }), g(u.hit, w, 13), g(u.seen, w, 7);
    let I = z && p(f, z);
    c(o, [w, I]), g(s.hit, I, 16), s.seen.setAttribute("d", I ? `M${I[0] - 8} ${I[1]}h16M${I[0]} ${I[1] - 8}v16M${I[0] - 5} ${I[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let B = t.effect(() => {
    let d = t.target.value, f = t.view.value;
    e.classList.toggle("empty", !d || !f), d && f && V(d, f);
  }), _n = (d, f, k) => ir(d.hole, (f.clientX - k.left - d.fit.x) / d.fit.scale, (f.clientY - k.top - d.fit.y) / d.fit.scale);
  function Oe(d, f, k) {
    d.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let T = t.view.peek();
      if (!T || !t.target.peek()) return;
      let C = e.getBoundingClientRect(), z = k(T), I = t.hold(f), O = _n(T, w, C);
      z(O, !1, { ...I, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), d.setPointerCapture(w.pointerId), d.classList.add("held");
      let U = (Z) => {
        m.textContent = z(_n(T, Z, C), Z.ctrlKey || Z.metaKey, I), m.setAttribute("x", String(Z.clientX - C.left + 16)), m.setAttribute("y", String(Z.clientY - C.top - 12));
      }, q = (Z) => {
        d.removeEventListener("pointermove", U), d.removeEventListener("pointerup", it), d.removeEventListener("pointercancel", We), removeEventListener("keydown", Ge, !0), d.classList.remove("held"), m.textContent = "", Z ? I.end() : I.cancel();
      }, it = () => q(!0), We = () => q(!1), Ge = (Z) => {
        Z.key === "Escape" && (Z.stopPropagation(), q(!1));
      };
      d.addEventListener("pointermove", U), d.addEventListener("pointerup", it), d.addEventListener("pointercancel", We), addEventListener("keydown", Ge, !0);
    });
  }
  let zt = (d, f, k) => k ? Math.round(d / f) * f : d, Xt = (d) => d.map((f) => f.toFixed(2)).join("  ") + " m";
  we.forEach((d, f) => {
    Oe(i[f].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (T, C, z) => {
        let I = hr(k, d, T);
        w ??= I;
        let O = re(d, zt(I - w, wa, C));
        return z.move(O), Xt(O);
      };
    }), Oe(l[f].group, "move", () => jn(d)), Oe(r[f].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (T, C, z) => {
        let I = Ma(k.position, d, T), O = I && cn(Te(I, k.position), sr(d));
        if (!O) return "";
        w.at ??= O;
        let U = Math.atan2(me(d, ur(w.at, O)), me(w.at, O)), q = zt(U, dr, C);
        return z.rotate(d, q), `${(q * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), Oe(u.group, "move", (d) => jn(d.hole.forward)), Oe(s.group, "aim", (d) => {
    let f = t.target.peek(), k = f.aim ?? le(f.position, re(f.direction, 3 * b(d, f.position))), w = zn(k, d.hole.forward);
    return (T, C, z) => {
      let I = w(T, C), O = le(k, I);
      return cr(O, f.position) > 1e-3 && z.turn(cn(Te(O, f.position)), O), Xt(O);
    };
  });
  function jn(d) {
    let f = zn(t.target.peek().position, d);
    return (k, w, T) => {
      let C = f(k, w);
      return T.move(C), Xt(C);
    };
  }
  function zn(d, f) {
    let k = null;
    return (w, T) => {
      let C = Ma(d, f, w);
      return C ? (k ??= C, Te(C, k).map((z) => zt(z, wa, T))) : [0, 0, 0];
    };
  }
  return { stop: B };
}
function hr(e, t, n) {
  let a = Te(e, n.origin), o = me(t, n.direction), r = 1 - o * o;
  return r < 1e-6 ? 0 : (o * me(n.direction, a) - me(t, a)) / r;
}
function Ma(e, t, n) {
  let a = me(t, n.direction);
  if (Math.abs(a) < 1e-4 * pr(t)) return null;
  let o = me(Te(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : le(n.origin, re(n.direction, o));
}

// src/later/handles.tsx
import { jsx as Wr } from "./desk.js";
function Rr([e, t, n, a], [o, r, l, i]) {
  return [
    a * o + e * i + t * l - n * r,
    a * r - e * l + t * i + n * o,
    a * l + e * r - t * o + n * i,
    a * i - e * o - t * r - n * l
  ];
}
var Fr = () => !wr.value && $r.value !== "watch" && fr.value.you && Vr.value !== "aim", Pa = mn(() => {
  let e = Lr.value;
  if (!e || !Fr()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => kt.get(a) && !kt.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = gr.value.filter((n) => La(yt.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), Ta = (e) => {
  let t = kt.get(e);
  return t?.place?.position ?? (t?.box ? xr(t.box) : null);
}, Hr = mn(() => {
  let e = Pa.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? La(yt.get(t)) : Ta(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? yt.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: kr.value
  };
}), Nr = mn(() => {
  let e = Pr.value;
  if (qr.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: Cr(e.camera, t, n), fit: vr(t, n) };
}), Dr = {
  effect: br,
  target: Hr,
  view: Nr,
  hold(e) {
    let t = Pa.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? Er(n) : n.length === 1 ? Mr("thing", n[0]) : `${n.length} things`, r = new yr(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), l = a === "lamps" ? Xe(n) : new Map(n.map((s) => [s, Ta(s)])), i = new Map(n.map((s) => [s, (a === "lamps" ? yt : kt).get(s)?.place])), u = (s) => {
      let m = n.map((p) => [p, s(p)]).filter(([, p]) => p);
      r.set({ [a]: Object.fromEntries(m.map(([p, b]) => [p, { place: b }])) });
    };
    return {
      move: (s) => a === "lamps" ? r.set(ze(n, s, l)) : u((m) => ({ position: Ca(l.get(m), s) })),
      turn: (s, m) => u((p) => i.get(p)?.direction ? { direction: s, ...m ? { aim: m } : {} } : null),
      rotate: (s, m) => u((p) => {
        let b = i.get(p);
        if (b?.direction) {
          let v = Sr($a(b.direction, s, m)), V = b.aim && b.position ? $a(Tr(b.aim, b.position), s, m) : null;
          return { direction: v, ...V ? { aim: Ca(b.position, V) } : {} };
        }
        let c = Math.sin(m / 2), g = [s[0] * c, s[1] * c, s[2] * c, Math.cos(m / 2)];
        return { rotation: Rr(g, b?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => r.end(),
      cancel: () => r.cancel()
    };
  }
};
function Or() {
  let e = Ir(null);
  return Ar(() => Sa(e.current, Dr).stop, []), Wr("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as wo, deselect as Bi, Icon as Vn, penless as An, selection as Ui, signal as _i } from "./desk.js";

// src/later/measure.tsx
import {
  deselect as Aa,
  digits as Ae,
  edit as xt,
  grids as jr,
  Icon as Ia,
  length as Ie,
  luxText as qe,
  maintenance as dn,
  meters as zr,
  selection as qa
} from "./desk.js";

// src/later/parts.tsx
import { Field as Ea, Gesture as Gr, Range as Kr, stroke as Br, useRef as Ur } from "./desk.js";
import { jsx as ie, jsxs as wt } from "./desk.js";
function R({ title: e, note: t, children: n }) {
  return wt("section", { class: "part", "aria-label": e, children: [
    wt("h3", { children: [
      e,
      t && ie("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function G(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function A(e) {
  return wt("label", { class: "line", children: [
    ie("span", { children: e.label }),
    ie(Ea, { ...e, label: e.name ?? e.label })
  ] });
}
function _r(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function J({ label: e, names: t, quantity: n, value: a, set: o, step: r, disabled: l }) {
  let i = t ?? ["X", "Y", "Z"];
  return wt("div", { class: "line", role: "group", "aria-label": e, children: [
    ie("span", { children: e }),
    ie("span", { class: "triple", children: i.map((u, s) => ie(
      Ea,
      {
        label: `${e} ${u}`,
        quantity: n,
        value: a[s],
        text: _r(a[s], n),
        step: r,
        disabled: l,
        set: (m) => o(s, m)
      },
      u
    )) })
  ] });
}
function Ee({ label: e, name: t, value: n, text: a, patch: o, reset: r, notch: l, class: i, style: u, disabled: s }) {
  let m = Ur(null), p = (c) => () => {
    m.current?.[c](), m.current = null;
  }, b = (c) => m.current ? m.current.set(o(c)) : Br(e + t, t, o(c));
  return ie(
    Kr,
    {
      label: e,
      value: n,
      text: a,
      notch: l,
      class: i,
      gradient: u,
      disabled: s,
      begin: () => m.current = new Gr(t),
      on: b,
      end: p("end"),
      cancel: p("cancel"),
      reset: r === void 0 ? void 0 : () => b(r)
    }
  );
}
function Ve({ value: e, label: t, set: n }) {
  return ie("span", { class: "field name-field", children: ie(
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
var se = (e, t, n) => e.map((a, o) => o === t ? n(a) : a);

// src/later/measure.tsx
import { Fragment as hn, jsx as P, jsxs as _ } from "./desk.js";
var Xr = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function Ra() {
  let e = qa.value?.ids[0], t = zr.get(e);
  if (!t) return P("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: r, ...l } = { ...t, ...o };
    xt(`${t.name}: ${a}`, { meters: { [e]: l } });
  };
  return _(hn, { children: [
    P("header", { class: "panel-head", children: P(Ve, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    P("p", { class: "crumbs", children: t.lux?.[1] != null ? `${qe(t.lux[0] * dn.value)} ±${qe(t.lux[1] * dn.value, !1)}` : "measuring" }),
    P("div", { class: "scroll", children: _(R, { title: "Meter", children: [
      _("label", { class: "line", children: [
        P("span", { children: "Measures" }),
        P("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: Xr.map(([a, o]) => P("option", { value: a, children: o }, a)) })
      ] }),
      P(J, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: se(t.point, a, o) }) }),
      P(A, { label: "Shall read", quantity: "lux", step: 50, value: t.target ?? 0, set: (a) => n("target", { target: a(t.target ?? 0) || null }) }),
      P(J, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: se(t.normal, a, o) }) }),
      _("button", { class: "plain full", onClick: () => {
        Aa(), xt(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        P(Ia, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var Va = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function Fa() {
  let e = qa.value?.ids[0], t = jr.get(e);
  if (!t) return P("p", { class: "quiet empty", children: "This grid is gone." });
  let n = dn.value, a = (i, u) => {
    let { name: s, corner: m, u: p, v: b, normal: c, columns: g, rows: v, target: V } = { ...t, ...u };
    xt(`${t.name}: ${i}`, { grids: { [e]: { name: s, corner: m, u: p, v: b, normal: c, columns: g, rows: v, target: V } } });
  }, o = () => {
    let i = tn(Math.max(Ie(t.u), Ie(t.v)));
    a("standard spacing", { columns: Math.max(1, Math.ceil(Ie(t.u) / i)), rows: Math.max(1, Math.ceil(Ie(t.v) / i)) });
  }, r = (i, u, s) => _(hn, { children: [
    P("dt", { children: i }),
    P("dd", { children: u == null ? "…" : s(u) })
  ] }), l = t.target ?? { lux: 500, uniformity: 0.6 };
  return _(hn, { children: [
    P("header", { class: "panel-head", children: P(Ve, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    _("p", { class: "crumbs", children: [
      Ae(Ie(t.u), 2),
      " × ",
      Ae(Ie(t.v), 2),
      " m, ",
      Ae(t.columns * t.rows),
      " points"
    ] }),
    _("div", { class: "scroll", children: [
      P(R, { title: "Figures", note: n === 1 ? "new" : `× ${Ae(n, 2)}`, children: _("dl", { class: "figures", children: [
        r("Ē", t.mean, (i) => qe(i * n)),
        r("E min", t.min, (i) => qe(i * n)),
        r("E max", t.max, (i) => qe(i * n)),
        r("U₀ = min / mean", t.uniformity, (i) => Ae(i, 2)),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => Ae(i, 2)),
        r("± of Ē", t.error, (i) => qe(i * n))
      ] }) }),
      _(R, { title: "Target", children: [
        _("label", { class: "line", children: [
          P("span", { children: "Class" }),
          _("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let u = Va[Number(i.currentTarget.value)];
            a("target", { target: u ? { lux: u[1], uniformity: u[2] } : null });
          }, children: [
            P("option", { value: "", children: t.target ? "choose…" : "none" }),
            Va.map(([i, u, s], m) => _("option", { value: m, children: [
              i,
              ": ",
              u,
              " lx, U₀ ",
              s
            ] }, i)),
            P("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        P(A, { label: "Ē at least", quantity: "lux", step: 50, value: l.lux, set: (i) => a("target", { target: { ...l, lux: i(l.lux) } }) }),
        P(A, { label: "U₀ at least", quantity: "share", step: 0.05, value: l.uniformity, set: (i) => a("target", { target: { ...l, uniformity: i(l.uniformity) } }) })
      ] }),
      _(R, { title: "Area", children: [
        P(J, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, u) => a("move", { corner: se(t.corner, i, u) }) }),
        P(A, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        P(A, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        P("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: o, children: "Spacing of the standard" }),
        _("button", { class: "plain full", onClick: () => {
          Aa(), xt(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          P(Ia, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as he,
  chosenLamps as ui,
  dot as yn,
  edit as Ct,
  format as ja,
  groups as $t,
  handles as Mt,
  Icon as Fe,
  lamps as Mn,
  layers as ci,
  lumensOf as pi,
  normal as za,
  output as mi,
  percent as xn,
  positionOf as Wa,
  selection as kn,
  signal as Xa,
  spot as di,
  sub as Ga,
  titleOf as Sn,
  tool as Qa,
  toLevel as Ka,
  toTravel as hi,
  typeLevel as wn,
  up as gi,
  Fade as fi,
  Field as bi,
  wantLevel as Ba,
  compass as Ya,
  add as Lt,
  scale as He,
  length as vi,
  Range as yi,
  strokeLevel as Ua,
  useRef as ki
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as Jr,
  digits as Na,
  edit as ei,
  fromHex as ti,
  hex as ni,
  lamps as Da,
  mired as xe,
  titleOf as ai
} from "./desk.js";

// src/later/white.ts
import { css as Qr, mired as gn } from "./desk.js";
function Yr(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((r) => Math.max(0, r));
}
function Zr(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function Ha(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, r) => {
    let l = gn(e) + (gn(t) - gn(e)) * r / (n - 1);
    return Qr(Yr(...Zr(1e6 / l)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as bn, jsx as N, jsxs as de } from "./desk.js";
var Je = 1800, vn = 1e4, oi = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], li = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], ri = Ha(Je, vn), fn = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(Da.get(n).color) }]))
}), ii = (e) => {
  let t = 1e6 / (xe(Je) + (xe(vn) - xe(Je)) * e);
  return Math.round(t / 10) * 10;
}, si = (e) => (xe(e) - xe(Je)) / (xe(vn) - xe(Je));
function Oa() {
  let e = Jr.value, t = e.map((l) => Da.get(l)?.color).filter((l) => l !== void 0);
  if (!t.length) return null;
  let n = G(t.map((l) => l.mode)), a = t[0], o = ai(e), r = (l, i) => ei(`${o}: ${l}`, fn(e, i));
  return de(bn, { children: [
    de("div", { class: "line", children: [
      N("span", { children: "Colour" }),
      N("div", { class: "segments", role: "group", "aria-label": "Colour by", children: li.map(([l, i]) => N("button", { "aria-pressed": n === l, onClick: () => r(`colour by ${i}`, () => ({ mode: l })), children: i }, l)) })
    ] }),
    n === "kelvin" && de(bn, { children: [
      de("div", { class: "line slide", children: [
        N("span", { children: "White" }),
        N(
          Ee,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: ri,
            value: si(a.kelvin),
            text: `${Na(a.kelvin)} kelvin`,
            patch: (l) => fn(e, () => ({ mode: "kelvin", kelvin: ii(l) }))
          }
        )
      ] }),
      N(
        A,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: G(t.map((l) => l.kelvin)),
          step: 50,
          set: (l) => r("white", (i) => ({ mode: "kelvin", kelvin: l(i.kelvin) }))
        }
      ),
      N("div", { class: "whites", role: "group", "aria-label": "Whites", children: oi.map(([l, i]) => N("button", { title: i, "aria-label": `${l} kelvin, ${i}`, onClick: () => r(`${l} K`, () => ({ mode: "kelvin", kelvin: l })), children: l }, l)) }),
      de("div", { class: "line slide", children: [
        N("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        N(
          Ee,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${Na(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (l) => fn(e, () => ({ tint: Math.round((l * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      N(A, { label: "", name: "Tint, typed", quantity: "number", value: G(t.map((l) => l.tint)), step: 1, set: (l) => r("tint", (i) => ({ tint: Math.max(-50, Math.min(50, l(i.tint))) })) })
    ] }),
    n === "rgb" && de(bn, { children: [
      de("label", { class: "line", children: [
        N("span", { children: "Colour" }),
        N("input", { type: "color", class: "pick", "aria-label": "Colour", value: ni(a.rgb), onChange: (l) => r("colour", () => ({ mode: "rgb", rgb: ti(l.currentTarget.value) })) })
      ] }),
      N(
        J,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (l, i) => r("colour", (u) => ({ rgb: u.rgb.map((s, m) => m === l ? Math.max(0, i(s)) : s) }))
        }
      )
    ] }),
    n === "xy" && de("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      N("span", { children: "x, y" }),
      N("span", { class: "triple", children: [0, 1].map((l) => N(
        A,
        {
          label: "xy"[l],
          quantity: "number",
          step: 1e-3,
          value: G(t.map((i) => i.xy[l])),
          set: (i) => r("chromaticity", (u) => ({ xy: u.xy.map((s, m) => m === l ? Math.max(0.01, Math.min(0.9, i(s))) : s) }))
        },
        l
      )) })
    ] }),
    n === null && N("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as Cn, jsx as y, jsxs as D } from "./desk.js";
var Re = Xa(1), St = Xa([1, 0, 0]), wi = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], Pt = 180 / Math.PI;
function _a(e, t) {
  let { right: n, ahead: a } = Ya(t), o = -yn(e, t);
  return [Math.atan2(yn(e, n), yn(e, a)) * Pt, Math.asin(Math.max(-1, Math.min(1, o))) * Pt];
}
function xi(e, t, n) {
  let { right: a, ahead: o } = Ya(n), [r, l] = [e / Pt, t / Pt], i = Lt(He(a, Math.sin(r)), He(o, Math.cos(r)));
  return za(Lt(He(i, Math.cos(l)), He(n, -Math.sin(l))));
}
function Mi({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction);
  return D("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    D("button", { "aria-pressed": Qa.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => he("aim"), children: [
      y(Fe, { name: "aim" }),
      "Aim"
    ] }),
    y("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => he("solo"), children: y(Fe, { name: "solo" }) }),
    y("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => he("from-lamp"), children: y(Fe, { name: "eye" }) }),
    y("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => he("frame"), children: y(Fe, { name: "frame" }) }),
    y("span", { class: "gap" }),
    y("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => he("park"), children: "Park" }),
    y("button", { class: "icon", "aria-label": `Remove ${Sn(e)}`, title: "Remove (Del)", onClick: () => he("remove"), children: y(Fe, { name: "bin" }) })
  ] });
}
function Si({ ids: e, all: t }) {
  let n = G(t.map((l) => l.level)), a = pi(e), o = t.every((l) => l.free), r = e[e.length - 1];
  return D(R, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    D("div", { class: "line slide", children: [
      y("span", { children: "Level" }),
      y(Ci, { id: r })
    ] }),
    D("label", { class: "line", children: [
      y("span", {}),
      y(
        bi,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: G(t.map((l) => l.flux)) ?? void 0,
          step: 0.01,
          set: (l) => wn(e, l),
          open: Ba.value,
          opened: () => Ba.value = "",
          id: "level"
        }
      )
    ] }),
    y(
      A,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (l) => wn(e, (i, u) => l(i * u) / u)
      }
    ),
    D("div", { class: "line", children: [
      y("span", { children: "Stops" }),
      y("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: wi.map(([l, i]) => y("button", { "aria-label": `${i} stop`, onClick: () => wn(e, (u) => Math.min(1e3, u * 2 ** l)), children: i }, i)) })
    ] }),
    D("p", { class: "sum", children: [
      ja(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && ($t.get(t[0].group)?.level ?? 1) !== 1 && ` (${xn(t[0].level)} % × ${xn($t.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    y(Oa, {})
  ] });
}
function Ci({ id: e }) {
  let t = ki(null), n = Mn.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (r) => () => {
    t.current?.[r](), t.current = null;
  };
  return y(
    yi,
    {
      label: "Level",
      value: hi(n.level),
      text: `${xn(n.level)} %, ${ja(n.flux * mi(n), "flux")}`,
      begin: () => t.current = new fi(a),
      on: (r) => t.current ? t.current.to(Ka(r)) : Ua(a, Ka(r)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => Ua(a, 1)
    }
  );
}
function et(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = Mn.get(o), l = n(r.place ?? {}, r);
    l && (a[o] = { place: l });
  }
  Object.keys(a).length && Ct(`${Sn(e)}: ${t}`, { lamps: a });
}
function $i({ ids: e, all: t }) {
  let n = (o) => G(t.map((r) => r.place?.[o] ?? null)), a = (o) => t.some((r) => r.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : D(R, { title: "Beam", note: "re-trace", children: [
    a("outer") && D(Cn, { children: [
      y(A, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => et(e, "beam", (r) => r.outer == null ? null : { inner: Math.max(0.1, Math.min(r.outer, o(r.inner ?? r.outer))) }) }),
      y(A, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => et(e, "beam", (r) => {
        if (r.outer == null) return null;
        let l = Math.max(0.2, Math.min(179, o(r.outer)));
        return { outer: l, inner: Math.min(r.inner ?? l, l) };
      }) })
    ] }),
    a("radius") && y(A, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => et(e, "radius", (r) => r.radius == null ? null : { radius: Math.max(1e-3, o(r.radius)) }) })
  ] });
}
function Li({ ids: e, all: t }) {
  let n = t.filter((p) => Wa(p) !== null);
  if (!n.length) return null;
  let a = n.map((p) => Wa(p)), o = (p, b) => G(b.map((c) => Math.round(c[p] * 1e4) / 1e4)), r = t.filter((p) => p.place?.direction), l = gi.value, i = r.map((p) => _a(p.place?.direction, l).map((b) => Math.round(b * 10) / 10)), u = t.map((p) => p.place?.aim).filter((p) => !!p), s = (p, b) => {
    let c = Xe(e), g = {};
    for (let [v, V] of c) {
      let B = [0, 0, 0];
      B[p] = b(V[p]) - V[p], Object.assign(g, ze([v], B, c).lamps);
    }
    Ct(`Move ${Sn(e)}`, { lamps: g });
  }, m = (p, b) => et(e, p ? "tilt" : "pan", (c) => {
    if (!c.direction) return null;
    let g = _a(c.direction, l);
    g[p] = b(g[p]);
    let v = xi(g[0], Math.max(-90, Math.min(90, g[1])), l), V = c.aim && c.position ? vi(Ga(c.aim, c.position)) : 0;
    return { direction: v, ...V && c.position ? { aim: Lt(c.position, He(v, V)) } : {} };
  });
  return D(R, { title: "Place", note: "re-trace", children: [
    y(J, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((p) => o(p, a)), set: s }),
    r.length > 0 && D(Cn, { children: [
      y(A, { label: "Pan", quantity: "angle", step: 1, value: G(i.map((p) => p[0])), set: (p) => m(0, p) }),
      y(A, { label: "Tilt", quantity: "angle", step: 1, value: G(i.map((p) => p[1])), set: (p) => m(1, p) }),
      y(
        J,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: u.length ? [0, 1, 2].map((p) => o(p, u)) : [NaN, NaN, NaN],
          set: (p, b) => et(e, "aim", (c) => {
            if (!c.direction || !c.position) return null;
            let g = se(c.aim ?? Lt(c.position, He(c.direction, 2)), p, b);
            return { aim: g, direction: za(Ga(g, c.position)) };
          })
        }
      )
    ] }),
    D("div", { class: "line", children: [
      y("span", { children: "Handles" }),
      D("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        y("button", { "aria-pressed": Mt.value === "move", onClick: () => Mt.value = "move", children: "Move" }),
        y("button", { "aria-pressed": Mt.value === "turn", onClick: () => Mt.value = "turn", children: "Turn" })
      ] })
    ] }),
    y("button", { class: "plain full", "aria-pressed": Qa.value === "place", onClick: () => he("place"), children: "Put on a surface by pointing" }),
    r.length > 0 && di.value && y("button", { class: "plain full", onClick: () => he("aim-here"), children: "Aim at the last point" })
  ] });
}
function Pi({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : D(R, { title: "Copies along a line", children: [
    y(A, { label: "How many", quantity: "number", step: 1, value: Re.value, set: (n) => Re.value = Math.max(1, Math.min(100, Math.round(n(Re.value)))) }),
    y(J, { label: "Step", quantity: "length", step: 0.05, value: St.value, set: (n, a) => St.value = se(St.value, n, a) }),
    D("button", { class: "plain full", onClick: () => gt(e, Re.value, St.value), children: [
      y(Fe, { name: "copy" }),
      Re.value === 1 ? "One copy" : `${Re.value} copies`
    ] })
  ] });
}
function Za() {
  let e = ui.value, t = e.map((l) => Mn.get(l)).filter((l) => !!l);
  if (!t.length) return y("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && $t.get(n.group), o = kn.value?.kind === "group" ? $t.get(kn.value.ids[0]) : void 0, r = n?.layer != null ? ci.value[n.layer] : void 0;
  return D(Cn, { children: [
    y("header", { class: "panel-head", children: n ? y(Ve, { label: "Name of the lamp", value: n.name, set: (l) => Ct(`Rename ${n.name}`, { lamps: { [e[0]]: { name: l } } }) }) : o ? y(Ve, { label: "Name of the group", value: o.name, set: (l) => Ct(`Rename ${o.name}`, { groups: { [kn.value.ids[0]]: { name: l } } }) }) : D("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    y("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((l) => l.on).length} of ${t.length} on` }),
    D("div", { class: "scroll", children: [
      y(Mi, { ids: e, all: t }),
      y(Si, { ids: e, all: t }),
      y(R, { title: "Photometry", children: y("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      y($i, { ids: e, all: t }),
      y(Li, { ids: e, all: t }),
      y(Pi, { ids: e, all: t }),
      y("p", { class: "cost", children: t.every((l) => l.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as $n,
  candles as Tt,
  command as Ti,
  digits as Vt,
  edit as Ja,
  Field as Ei,
  filterOf as ao,
  go as Vi,
  history as Ai,
  hovered as eo,
  Icon as At,
  layers as Ii,
  lookOnly as to,
  maintenance as Ne,
  materials as qi,
  percent as Ri,
  scene as Fi,
  select as oo,
  signal as Hi,
  singleKeys as no,
  sub as Ni,
  things as Di,
  travel as Et,
  Virtual as lo
} from "./desk.js";
import { Fragment as Oi, jsx as M, jsxs as E } from "./desk.js";
function ro() {
  let e = Fi.value;
  if (!e) return null;
  let t = Ni(e.bounds[1], e.bounds[0]);
  return E(Oi, { children: [
    E(R, { title: "Room", children: [
      E("p", { children: [
        t.map((n) => Vt(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${Vt(e.triangles)} triangles` : ""
      ] }),
      M("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && M("ul", { class: "buttons", children: e.cameras.map((n, a) => M("li", { children: M("button", { onClick: () => Vi(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && E("details", { children: [
        E("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        M("ul", { class: "remarks", children: e.warnings.map((n) => M("li", { children: n }, n)) })
      ] })
    ] }),
    E(R, { title: "Figures", children: [
      E("label", { class: "line", children: [
        M("span", { children: "Maintenance" }),
        M(Ei, { label: "Maintenance factor", quantity: "share", value: Ne.value, step: 0.05, set: (n) => Ne.value = Math.max(0.1, Math.min(1, n(Ne.value))) })
      ] }),
      E("p", { class: "quiet", children: [
        Ne.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Ne.value === 1 && M("button", { class: "plain", onClick: () => Ne.value = 0.8, children: "0.80" })
      ] }),
      E("div", { class: "line", children: [
        M("span", { children: "Unit" }),
        E("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          M("button", { "aria-pressed": Tt.value === "lx", onClick: () => Tt.value = "lx", children: "lx, cd/m²" }),
          M("button", { "aria-pressed": Tt.value === "fc", onClick: () => Tt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    M(R, { title: "Layers of light", children: M("ul", { class: "layers", children: Ii.value.map((n, a) => E("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      M("i", { class: "dot", "aria-hidden": "true" }),
      M("span", { children: n.name || `layer ${a + 1}` }),
      M("small", { children: n.held ? "held" : Ri(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    E(R, { title: "Hands", children: [
      E("div", { class: "line", children: [
        M("span", { children: "Faders" }),
        E("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          M("button", { "aria-pressed": Et.value === "square", onClick: () => Et.value = "square", children: "Square law" }),
          M("button", { "aria-pressed": Et.value === "linear", onClick: () => Et.value = "linear", children: "Even" })
        ] })
      ] }),
      E("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: no.value, onChange: (n) => no.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      E("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: to.value, onChange: (n) => to.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var It = Hi("");
function io({ label: e }) {
  return M("span", { class: "field filter", children: M("input", { type: "text", "aria-label": e, placeholder: "Filter", value: It.value, onInput: (t) => It.value = t.currentTarget.value }) });
}
function so() {
  let e = ao(Di, It.value);
  return E("div", { class: "listing", children: [
    M(io, { label: "Filter things" }),
    M(
      lo,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => eo.value = { kind: "thing", id: n }, onPointerLeave: () => eo.value = null, children: [
            M("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => Ja(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: M(At, { name: a.hidden ? "eye-off" : "eye" }) }),
            M("button", { class: "row-name", onClick: () => oo("thing", n), children: M("span", { children: a.name }) }),
            M("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => Ja(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: M(At, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function uo() {
  let e = ao(qi, It.value);
  return E("div", { class: "listing", children: [
    M(io, { label: "Filter materials" }),
    M(
      lo,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row material", role: "listitem", children: [
            M("button", { class: "row-name", onClick: () => oo("material", n), children: M("span", { children: a.name }) }),
            E("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${Vt(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function co() {
  let e = Ai.value;
  return E(R, { title: "History", children: [
    E("p", { children: [
      e.steps === 1 ? "One step" : `${Vt(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => $n("undo"), children: [
      M(At, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => $n("redo"), children: [
      M(At, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    M("button", { class: "plain full", onClick: () => $n("save"), children: "Save a version with a name…" }),
    M("button", { class: "plain full", onClick: () => Ti({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as Ln,
  edit as go,
  fromHex as Wi,
  hex as Gi,
  Icon as po,
  materials as fo,
  middle as mo,
  select as bo,
  selection as vo,
  things as Pn
} from "./desk.js";
import { Fragment as En, jsx as $, jsxs as X } from "./desk.js";
var Tn = 180 / Math.PI;
function ho(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * Tn : 0;
}
function Ki(e, t) {
  let n = [0, 0, 0, Math.cos(t / Tn / 2)];
  return n[e] = Math.sin(t / Tn / 2), n;
}
function yo() {
  let e = (vo.value?.ids ?? []).filter((u) => Pn.get(u)), t = e.map((u) => Pn.get(u));
  if (!t.length) return $("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((u) => u.locked), r = (u, s) => go(`${a}: ${u}`, { things: Object.fromEntries(e.map((m, p) => [m, s(t[p])])) }), l = t.map((u) => u.place?.position ?? (u.box ? mo(u.box) : [0, 0, 0])), i = n.box ? [0, 1, 2].map((u) => n.box[1][u] - n.box[0][u]) : null;
  return X(En, { children: [
    $("header", { class: "panel-head", children: $("h2", { children: a }) }),
    i && X("p", { class: "crumbs", children: [
      i.map((u) => Ln(u, 2)).join(" × "),
      " m"
    ] }),
    X("div", { class: "scroll", children: [
      X("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        X("button", { "aria-pressed": t.every((u) => u.hidden), onClick: () => r(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          $(po, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        X("button", { "aria-pressed": o, onClick: () => r(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          $(po, { name: o ? "lock" : "unlock" }),
          o ? "Locked" : "Lock"
        ] })
      ] }),
      X(R, { title: "Place", note: "re-trace", children: [
        o && $("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        $(
          J,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: o,
            value: [0, 1, 2].map((u) => G(l.map((s) => Math.round(s[u] * 1e4) / 1e4))),
            set: (u, s) => r("move", (m) => ({ place: { position: se(m.place?.position ?? mo(m.box), u, s) } }))
          }
        ),
        [0, 1, 2].map((u) => $(
          A,
          {
            label: `Turn ${"XYZ"[u]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: G(t.map((s) => Math.round(ho(s.place?.rotation, u) * 10) / 10)),
            set: (s) => r("turn", (m) => ({ place: { rotation: Ki(u, s(ho(m.place?.rotation, u))) } }))
          },
          u
        )),
        $(
          A,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: o,
            value: G(t.map((u) => u.place?.scale ?? 1)),
            set: (u) => r("scale", (s) => ({ place: { scale: Math.max(1e-3, u(s.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      $(R, { title: "Materials", children: $("ul", { class: "buttons", children: n.materials.map((u) => $("li", { children: $("button", { onClick: () => bo("material", u), children: fo.get(u)?.name ?? `material ${u}` }) }, u)) }) })
    ] })
  ] });
}
function ko() {
  let e = vo.value?.ids[0], t = fo.get(e);
  if (!t) return $("p", { class: "quiet empty", children: "This material is gone." });
  let n = (s, m) => go(`${t.name}: ${s}`, { materials: { [e]: m } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], l = ((s) => 0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2])(o), i = (s) => o.map((m) => Math.max(0, Math.min(1, l > 1e-4 ? m / l * s : s))), u = (s, m) => t[m] != null && X(En, { children: [
    X("div", { class: "line slide", children: [
      $("span", { children: s }),
      $(Ee, { label: s, name: `${t.name}: ${s.toLowerCase()}`, value: t[m], text: Ln(t[m], 2), patch: (p) => ({ materials: { [e]: { [m]: Math.round(p * 1e3) / 1e3 } } }) })
    ] }),
    $(A, { label: "", name: `${s}, typed`, quantity: "share", step: 0.01, value: t[m], set: (p) => n(s.toLowerCase(), { [m]: Math.max(0, Math.min(1, p(t[m]))) }) })
  ] });
  return X(En, { children: [
    $("header", { class: "panel-head", children: $("h2", { children: t.name }) }),
    $("p", { class: "crumbs", children: t.kind }),
    X("div", { class: "scroll", children: [
      X(R, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        X("div", { class: "line slide", children: [
          $("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          $(Ee, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: l, text: Ln(l, 2), patch: (s) => ({ materials: { [e]: { [a]: i(Math.min(0.95, s)) } } }) })
        ] }),
        $(A, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(l * 1e3) / 1e3, set: (s) => n("reflectance", { [a]: i(Math.min(0.98, s(l))) }) }),
        X("label", { class: "line", children: [
          $("span", { children: "Colour" }),
          $("input", { type: "color", class: "pick", "aria-label": "Colour", value: Gi(o), onChange: (s) => n("colour", { [a]: Wi(s.currentTarget.value) }) })
        ] }),
        u("Roughness", "roughness"),
        u("Gloss", "specular")
      ] }),
      $(R, { title: "On", children: $("ul", { class: "buttons", children: Pn.all().filter(([, s]) => s.materials.includes(e)).slice(0, 40).map(([s, m]) => $("li", { children: $("button", { onClick: () => bo("thing", s), children: m.name }) }, s)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as xo, jsx as H, jsxs as qt } from "./desk.js";
var tt = ["Scene", "Things", "Materials", "History"], ge = _i("Scene");
function ji() {
  let e = { Scene: ro, Things: so, Materials: uo, History: co }[ge.value];
  return qt(xo, { children: [
    H("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), ge.value = tt[(tt.indexOf(ge.value) + a + tt.length) % tt.length], document.getElementById(`tab-${ge.value}`)?.focus());
    }, children: tt.map((n) => H("button", { id: `tab-${n}`, role: "tab", "aria-selected": ge.value === n, "aria-controls": "tab-panel", tabIndex: ge.value === n ? 0 : -1, onClick: () => ge.value = n, children: n }, n)) }),
    H("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${ge.value}`, tabIndex: 0, children: H(e, {}) })
  ] });
}
function zi() {
  let e = Ui.value;
  return e ? qt(xo, { children: [
    qt("nav", { class: "chooser", "aria-label": "Selection", children: [
      H("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => wo("previous"), children: H(Vn, { name: "back" }) }),
      H("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => wo("next"), children: H(Vn, { name: "forth" }) }),
      H("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      H("span", { class: "gap" }),
      H("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: Bi, children: H(Vn, { name: "close" }) })
    ] }),
    An.value && H("p", { class: "penless", children: An.value }),
    qt("fieldset", { class: "editing", disabled: An.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && H(Za, {}),
      e.kind === "thing" && H(yo, {}),
      e.kind === "material" && H(ko, {}),
      e.kind === "meter" && H(Ra, {}),
      e.kind === "grid" && H(Fa, {})
    ] })
  ] }) : H(ji, {});
}

// src/later/legend.tsx
import { asked as Xi, candles as Qi, DEFAULT_FALSE as Yi, display as Zi, Field as Ji, looks as es, show as So, three as ts, useRef as ns } from "./desk.js";
import { Fragment as rs, jsx as j, jsxs as Me } from "./desk.js";
var In = [1, 2, 5];
function as(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, r = 10 ** Math.floor(Math.log10(o)), l = r * (In.find((i) => i * r >= o) ?? 10);
    for (let i = Math.ceil(e / l) * l; i <= t * 1.0001; i += l) a.push(i);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let r of In) {
      let l = r * 10 ** o;
      l >= e * 0.999 && l <= t * 1.001 && a.push(l);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function os(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var ne = (e, t) => {
  let n = Xi({ ...e, ...t });
  n.against != null && (n = Qn(n)), n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && So({ false_color: n });
};
function Mo(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return In[a] * 10 ** ((n - a) / 3);
}
function ls() {
  let e = Zi.value.false_color, t = ns(null);
  if (!e) return null;
  let n = Qi.value === "fc", a = e.quantity === "difference", o = e.quantity !== "luminance", r = o ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", l = n ? o ? 1 / 10.7639 : 0.2919 : 1, i = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, u = e.ticks ?? as(e.low, e.high, e.scale).map((c) => [c, os(c, e)]), s = (c) => {
    let g = String(Number(c.toPrecision(2)));
    return a ? g.replace("-", "−").replace(/^(?=[1-9]|0\.)/, "+") : g;
  }, m = (c, g, v) => a ? { high: Mo(Math.abs(g), c === "low" ? -v : v) } : { [c]: Mo(g, v) }, p = (c) => ({
    onPointerDown: (g) => {
      g.currentTarget.setPointerCapture(g.pointerId), t.current = { y: g.clientY, end: c, from: e[c] };
    },
    onPointerMove: (g) => {
      let v = t.current;
      v?.end === c && ne(e, m(c, v.from, Math.round((v.y - g.clientY) / 14)));
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (g) => {
      let v = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[g.key];
      v && (g.preventDefault(), g.stopPropagation(), ne(e, m(c, e[c], v)));
    }
  }), b = ({ end: c }) => Me("div", { class: "end", children: [
    j(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": c === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[c],
        "aria-valuemin": a ? -1e6 : 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${ts(e[c] * l)} ${r}`,
        ...p(c)
      }
    ),
    a && c === "low" ? j("output", { children: s(e.low * l) }) : j(
      Ji,
      {
        label: c === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[c] * l).toPrecision(3)),
        set: (g) => ne(e, { [c]: g(e[c] * l) / l })
      }
    )
  ] });
  return Me("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    Me("header", { children: [
      j(
        "button",
        {
          "aria-label": `${r}: ${a ? "difference" : e.quantity}, change`,
          onClick: () => a ? So({ false_color: Yi }) : ne(e, { quantity: o ? "luminance" : "illuminance" }),
          children: a ? `Δ ${r}` : r
        }
      ),
      !a && j("button", { "aria-pressed": e.scale === "log", onClick: () => ne(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      j("button", { "aria-pressed": e.lines, onClick: () => ne(e, { lines: !e.lines }), children: "lines" })
    ] }),
    a && Me("p", { class: "quiet", title: e.exact === !1 ? "Lamps that differ in the look share a layer of light: what is shown of them is their mean." : void 0, children: [
      e.exact === !1 ? "≈ " : "",
      "now − ",
      es.get(e.against)?.name ?? "look"
    ] }),
    j(b, { end: "high" }),
    j("div", { class: "scale", style: { background: i }, children: u.map(([c, g]) => j("span", { style: { bottom: `${100 * g}%` }, children: s(c * l) }, c)) }),
    j(b, { end: "low" }),
    Me("footer", { children: [
      a ? [50, 500].map((c) => Me("button", { onClick: () => ne(e, { high: c }), children: [
        "±",
        c
      ] }, c)) : Me(rs, { children: [
        j("button", { onClick: () => ne(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
        j("button", { onClick: () => ne(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" })
      ] }),
      j(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (c) => ne(e, { palette: c.currentTarget.value }),
          children: e.palettes?.map((c) => j("option", { children: c }, c)) ?? j("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as Fn,
  act as Io,
  ask as fs,
  command as bs,
  copyText as vs,
  digits as ys,
  go as ks,
  hear as ws,
  lamps as xs,
  say as Nt,
  select as Ms,
  send as Ft,
  sheet as at,
  shown as Ss,
  signal as ot,
  useEffect as Hn,
  useLayoutEffect as Cs,
  useRef as Dt,
  walkNames as $s,
  whyNotTo as Ls
} from "./desk.js";

// src/later/csv.ts
import { add as Co, grids as is, maintenance as ss, meters as us, scale as $o, scene as Lo } from "./desk.js";
var cs = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function ps() {
  let e = ss.peek(), t = [["scene", Lo.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of us.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of is.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, r] of Object.entries(a)) t.push([o, r == null ? null : r * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, r) => {
      let [l, i] = [r % n.columns, Math.floor(r / n.columns)], u = Co(n.corner, Co($o(n.u, (l + 0.5) / n.columns), $o(n.v, (i + 0.5) / n.rows)));
      t.push([...u.map((s) => s.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(cs).join(",")).join(`\r
`) + `\r
`;
}
function qn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function Po() {
  let e = URL.createObjectURL(new Blob([ps()], { type: "text/csv" }));
  qn(`${Lo.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var Vo = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], Rt = new Uint8Array(512), Rn = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  Rt[e] = Rt[e + 255] = t, Rn[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var To = (e, t) => e && t ? Rt[Rn[e] + Rn[t]] : 0;
function ms(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let r = new Array(n.length + 1).fill(0);
    n.forEach((l, i) => {
      r[i] ^= l, r[i + 1] ^= To(l, Rt[o]);
    }), n = r;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let r = a[o];
    r && n.forEach((l, i) => a[o + i] ^= To(l, r));
  }
  return a.slice(e.length);
}
function ds(e, t) {
  let [n, a, o] = Vo[t - 1], r = [], l = (b, c) => {
    for (let g = c - 1; g >= 0; g--) r.push(b >> g & 1);
  };
  for (l(4, 4), l(e.length, 8), e.forEach((b) => l(b, 8)), l(0, Math.min(4, n * 8 - r.length)); r.length % 8; ) r.push(0);
  let i = [];
  for (let b = 0; b < r.length; b += 8) i.push(parseInt(r.slice(b, b + 8).join(""), 2));
  for (let b = 236; i.length < n; b ^= 253) i.push(b);
  let u = n / o, s = Array.from({ length: o }, (b, c) => i.slice(c * u, (c + 1) * u)), m = s.map((b) => ms(b, a)), p = (b) => b[0].flatMap((c, g) => b.map((v) => v[g]));
  return [...p(s), ...p(m)];
}
var hs = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function gs(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function Eo(e) {
  let t = e.length, n = 0, a = 0;
  for (let o of [!1, !0])
    for (let r = 0; r < t; r++) {
      let l = Array.from({ length: t }, (s, m) => o ? e[m][r] : e[r][m]), i = 1;
      for (let s = 1; s <= t; s++)
        s < t && l[s] === l[s - 1] ? i++ : (i >= 5 && (n += i - 2), i = 1);
      let u = l.map(Number).join("");
      for (let s = 0; s + 11 <= t; s++) {
        let m = u.slice(s, s + 11);
        (m === "10111010000" || m === "00001011101") && (n += 40);
      }
    }
  for (let o = 0; o < t; o++)
    for (let r = 0; r < t; r++)
      e[o][r] && a++, r && o && e[o][r] === e[o - 1][r] && e[o][r] === e[o][r - 1] && e[o][r] === e[o - 1][r - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function Ao(e) {
  let t = [...new TextEncoder().encode(e)], n = Vo.findIndex(([c]) => t.length + 2 <= c) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), r = Array.from({ length: a }, () => new Array(a).fill(!1)), l = (c, g, v) => {
    c < 0 || g < 0 || c >= a || g >= a || (o[g][c] = v, r[g][c] = !0);
  };
  for (let c = 0; c < a; c++)
    l(c, 6, c % 2 === 0), l(6, c, c % 2 === 0);
  for (let [c, g] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let v = -4; v <= 4; v++)
      for (let V = -4; V <= 4; V++) {
        let B = Math.max(Math.abs(V), Math.abs(v));
        l(c + V, g + v, B !== 2 && B !== 4);
      }
  if (n > 1) {
    let c = a - 7;
    for (let g = -2; g <= 2; g++) for (let v = -2; v <= 2; v++) l(c + v, c + g, Math.max(Math.abs(v), Math.abs(g)) !== 1);
  }
  let i = (c) => {
    let g = gs(c);
    for (let v = 0; v < 15; v++) {
      let V = (g >> v & 1) === 1, B = v < 6 ? v : v < 8 ? v + 1 : a - 15 + v;
      l(8, B, V), l(v < 8 ? a - 1 - v : v < 9 ? 7 : 14 - v, 8, V);
    }
    l(8, a - 8, !0);
  };
  i(0);
  let u = ds(t, n), s = 0;
  for (let c = a - 1; c > 0; c -= 2) {
    c === 6 && (c = 5);
    for (let g = 0; g < a; g++)
      for (let v of [c, c - 1]) {
        let B = (c + 1 & 2) === 0 ? a - 1 - g : g;
        r[B][v] || (o[B][v] = s < u.length * 8 && (u[s >> 3] >> 7 - (s & 7) & 1) === 1, s++);
      }
  }
  let m = (c) => (i(c), o.map((g, v) => g.map((V, B) => V !== (!r[v][B] && hs[c](B, v))))), p = m(0), b = Eo(p);
  for (let c = 1; c < 8; c++) {
    let g = m(c), v = Eo(g);
    v < b && ([p, b] = [g, v]);
  }
  return p;
}

// src/later/sheets.tsx
import { Fragment as Hs, jsx as h, jsxs as L } from "./desk.js";
function lt({ title: e, wide: t, children: n }) {
  let a = Dt(null);
  Cs(() => {
    let r = a.current, l = document.activeElement;
    return r.open || r.showModal(), () => l?.focus();
  }, []);
  let o = () => at.value = null;
  return h(
    "dialog",
    {
      ref: a,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: o,
      onClick: (r) => r.target === a.current && o(),
      children: L("div", { class: "sheet-body", children: [
        L("header", { children: [
          h("h2", { children: e }),
          h("span", { class: "gap" }),
          h("button", { onClick: o, children: "Close" })
        ] }),
        n
      ] })
    }
  );
}
var Ps = [
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
function Ts() {
  let e = [...new Set(Fn().map((t) => t.group))];
  return h(lt, { title: "All keys", wide: !0, children: L("div", { class: "help", children: [
    L("table", { children: [
      h("caption", { class: "spoken", children: "By hand" }),
      h("thead", { children: L("tr", { children: [
        h("th", { scope: "col", children: "What" }),
        h("th", { scope: "col", children: "Mouse" }),
        h("th", { scope: "col", children: "Keys, in the view" }),
        h("th", { scope: "col", children: "Fingers" })
      ] }) }),
      h("tbody", { children: Ps.map(([t, n, a, o]) => L("tr", { children: [
        h("th", { scope: "row", children: t }),
        h("td", { children: n }),
        h("td", { children: a.replace("walking keys", $s.value) }),
        h("td", { children: o })
      ] }, t)) })
    ] }),
    L("div", { class: "columns", children: [
      e.map((t) => L("section", { children: [
        h("h3", { children: t }),
        h("dl", { children: Fn().filter((n) => n.group === t && n.keys).map((n) => L(Hs, { children: [
          h("dt", { children: n.label }),
          h("dd", { children: h("kbd", { children: n.keys }) })
        ] })) })
      ] }, t)),
      L("section", { children: [
        h("h3", { children: "Numbers" }),
        L("dl", { children: [
          h("dt", { children: "Level" }),
          h("dd", { children: "80 %, 450 lm, *0.8, +10, -1/2 stop, full, out" }),
          h("dt", { children: "Colour" }),
          h("dd", { children: "2700K" }),
          h("dt", { children: "Length" }),
          h("dd", { children: `2.4m, 75cm, 8'2", +=0.1` }),
          h("dt", { children: "Angle" }),
          h("dd", { children: "30°" })
        ] })
      ] })
    ] })
  ] }) });
}
var Ht = ot(""), nt = ot(0);
function Es() {
  let e = Ht.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = Fn().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: Ls(a.id), run: () => Io(a.id) }));
  for (let { name: a, camera: o } of bt())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => ks(o, a) });
  if (e.length)
    for (let [a, o] of xs.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => Ms("lamp", a) });
    }
  return n.slice(0, 60);
}
function Vs() {
  let e = Es(), t = Math.min(nt.value, e.length - 1);
  Hn(() => {
    Ht.value = "", nt.value = 0;
  }, []), Hn(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (at.value = null, a.why ? Nt(a.why, "warn") : setTimeout(a.run, 0));
  };
  return L(lt, { title: "Command palette", children: [
    h(
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
        value: Ht.value,
        onInput: (a) => {
          Ht.value = a.currentTarget.value, nt.value = 0;
        },
        onKeyDown: (a) => {
          let o = { ArrowDown: 1, ArrowUp: -1 }[a.key];
          o && (a.preventDefault(), nt.value = (t + o + e.length) % Math.max(1, e.length)), a.key === "Enter" && (a.preventDefault(), n(e[t]));
        }
      }
    ),
    L("ul", { class: "commands", id: "commands", role: "listbox", "aria-label": "Commands", children: [
      e.map((a, o) => L(
        "li",
        {
          id: `command-${o}`,
          role: "option",
          "aria-selected": o === t,
          "aria-disabled": a.why !== null,
          title: a.why ?? void 0,
          onPointerMove: () => nt.value = o,
          onClick: () => n(a),
          children: [
            h("span", { children: a.label }),
            h("kbd", { children: a.note })
          ]
        },
        a.label + o
      )),
      !e.length && h("li", { class: "quiet", role: "option", "aria-selected": "false", "aria-disabled": "true", children: "Nothing is called so." })
    ] })
  ] });
}
var qo = ot([]);
ws("links", (e) => qo.value = e.links);
function As({ text: e }) {
  let t = Ao(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, r) => o.map((l, i) => l ? `M${i + 4} ${r + 4}h1v1h-1z` : "").join("")).join("");
  return L("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    h("rect", { width: n, height: n, fill: "#fff" }),
    h("path", { d: a, fill: "#000" })
  ] });
}
function Is() {
  let e = ot(null), t = Dt(e).current;
  return Hn(() => {
    Ft({ do: "links", what: "list" });
  }, []), L(lt, { title: "Share by link", children: [
    h("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    h("ul", { class: "links", children: qo.value.map((n) => L("li", { children: [
      h("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      h("code", { children: n.address }),
      L("span", { class: "buttons", children: [
        h("button", { onClick: () => {
          vs(n.address);
        }, children: "Copy" }),
        h("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        h("button", { onClick: () => Ft({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && h(As, { text: n.address })
    ] }, n.id)) }),
    L("footer", { children: [
      h("button", { onClick: () => Ft({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      h("button", { onClick: () => Ft({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function qs() {
  let e = Dt(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    bs({ do: "save", name: n }), at.value = null, Nt(`Saving the version “${n}”.`);
  };
  return L(lt, { title: "Save a version", children: [
    h("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    L("label", { class: "line", children: [
      h("span", { children: "Name" }),
      h("span", { class: "field", children: h("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    h("footer", { children: h("button", { onClick: t, children: "Save" }) })
  ] });
}
var ee = ot(null);
function Rs() {
  let e = Ss.value?.head, t = Dt(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    ee.value = 0;
    let [o, r] = [Number(n("width")), Number(n("height"))];
    fs("picture", { format: n("format"), width: o, height: r, batches: Number(n("batches")) }, (l) => {
      l.why ? (ee.value = null, Nt(l.why, "warn")) : l.url ? (ee.value = null, qn(l.name, l.url), at.value = null) : ee.value = l.progress ?? 0;
    }, (l) => {
      ee.value = null, Nt(l, "warn");
    });
  };
  return L(lt, { title: "Save the picture", children: [
    L("div", { ref: t, class: "form", children: [
      L("label", { class: "line", children: [
        h("span", { children: "Format" }),
        L("select", { name: "format", children: [
          h("option", { value: "png", children: "PNG, as it is shown" }),
          h("option", { value: "exr", children: "EXR, the light itself" })
        ] })
      ] }),
      L("label", { class: "line", children: [
        h("span", { children: "Width" }),
        h("input", { type: "number", name: "width", min: 16, max: 16384, value: Math.max(e?.width ?? 0, 640) })
      ] }),
      L("label", { class: "line", children: [
        h("span", { children: "Height" }),
        h("input", { type: "number", name: "height", min: 16, max: 16384, value: Math.max(e?.height ?? 0, 480) })
      ] }),
      L("label", { class: "line", children: [
        h("span", { children: "Batches" }),
        h("input", { type: "number", name: "batches", min: 1, max: 1e5, value: 64 })
      ] })
    ] }),
    ee.value !== null && h("progress", { max: 1, value: ee.value, "aria-label": "Rendering" }),
    L("footer", { children: [
      h("button", { onClick: () => Io("command"), children: "Copy the command" }),
      h("button", { disabled: ee.value !== null, onClick: a, children: ee.value === null ? "Render and save" : ee.value ? `${ys(ee.value * 100)} %` : "Rendering…" })
    ] })
  ] });
}
function Fs() {
  switch (at.value) {
    case "help":
      return h(Ts, {});
    case "palette":
      return h(Vs, {});
    case "share":
      return h(Is, {});
    case "save":
      return h(qs, {});
    case "picture":
      return h(Rs, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import {
  act as Ns,
  colorText as Ro,
  cost as Ds,
  css as Os,
  Field as Ws,
  groups as Gs,
  hovered as Ot,
  Icon as Ks,
  lamps as Bs,
  lumensOf as Us,
  penless as _s,
  pickRow as js,
  select as zs,
  selection as Fo,
  switchOn as Xs,
  three as Qs,
  typeGroupLevel as Ys,
  typeLevel as Zs
} from "./desk.js";
import { jsx as Y, jsxs as Nn } from "./desk.js";
function Js() {
  return Nn("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    Y("span", {}),
    Y("span", { children: "Name" }),
    Y("span", { children: "Level" }),
    Y("span", { children: "lm" }),
    Y("span", { children: "White" })
  ] });
}
function eu({ row: e, index: t, count: n }) {
  let a = e.kind === "lamp" ? Bs.get(e.id) : void 0, o = e.kind === "group" ? Gs.get(e.id) : void 0, r = a ?? o;
  if (!r) return null;
  let l = Fo.value?.kind === e.kind && Fo.value.ids.includes(e.id), i = Us(o?.lamps ?? [e.id]), u = _s.value, s = Ot.value?.kind === e.kind && Ot.value.id === e.id;
  return Nn(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${l ? "selected" : ""} ${r.on ? "" : "off"} ${s ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => Ot.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => Ot.value = null,
      children: [
        Y("button", { class: "icon power", "aria-pressed": r.on, disabled: u !== null, title: u ?? void 0, "aria-label": `${r.name} on`, onClick: () => Xs(e, !r.on), children: Y(Ks, { name: "power" }) }),
        Y("button", { class: "row-name", "aria-pressed": l, title: a ? Ds(a) : void 0, onClick: (m) => js(m, e.kind, e.id), onDblClick: () => Ns("frame"), children: Y("span", { children: r.name }) }),
        Y(
          Ws,
          {
            label: `${r.name} level`,
            quantity: "level",
            value: r.level,
            flux: a?.flux,
            step: 0.01,
            disabled: u !== null,
            why: u,
            set: (m) => a ? Zs([e.id], m) : Ys(e.id, m)
          }
        ),
        Y("span", { class: "lumens", children: Qs(i) }),
        a ? Nn("button", { class: "tint", "aria-label": `${r.name} colour: ${Ro(a)}`, onClick: () => zs("lamp", e.id), children: [
          Y("i", { class: "swatch", style: { background: Os(a.swatch) } }),
          Ro(a)
        ] }) : Y("span", {})
      ]
    }
  );
}

// src/later/strip.tsx
import {
  act as Dn,
  command as Ko,
  digits as On,
  display as tu,
  fade as Wt,
  Field as Bo,
  grids as Ho,
  Icon as De,
  looks as No,
  luxText as fe,
  maintenance as nu,
  meters as Do,
  select as Oo,
  selection as Gt,
  show as au,
  signal as ou,
  signed as lu,
  status as Wn,
  storeLook as ru
} from "./desk.js";
import { Fragment as pu, jsx as x, jsxs as F } from "./desk.js";
var Gn = ou("looks");
function iu() {
  return F("section", { class: "looks", "aria-label": "Looks", children: [
    F("header", { children: [
      x("h2", { children: "Looks" }),
      x("button", { class: "tab", onClick: () => Gn.value = "meters", children: "Meters" }),
      x("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: ru, children: x(De, { name: "plus" }) }),
      x("span", { class: "gap" }),
      F("label", { class: "tint", children: [
        "Fade",
        x(Bo, { label: "Cross-fade", quantity: "seconds", value: Wt.value, step: 0.5, set: (e) => Wt.value = Math.max(0, e(Wt.value)) })
      ] })
    ] }),
    F("ul", { children: [
      No.all().map(([e, t], n) => F("li", { class: "look", children: [
        F("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Ko({ do: "look", id: e, what: "recall", seconds: Wt.peek() }), children: [
          t.picture && x("img", { src: t.picture, alt: t.name, width: 96, height: 72 }),
          x("span", { "aria-hidden": t.picture ? "true" : void 0, children: t.name })
        ] }),
        x(su, { id: e, name: t.name })
      ] }, e)),
      !No.ids.value.length && x("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function su({ id: e, name: t }) {
  let n = `look-${e}`, a = (u) => {
    let s = u.getBoundingClientRect(), m = document.getElementById(n);
    m?.style.setProperty("left", `${Math.min(s.left, innerWidth - 296)}px`), m?.style.setProperty("bottom", `${innerHeight - s.top + 4}px`), m?.style.setProperty("top", "auto");
  }, o = tu.value.false_color?.against === e, r = { popovertarget: n }, l = () => document.getElementById(n)?.hidePopover(), i = (u, s = {}) => {
    l(), Ko({ do: "look", id: e, what: u, ...s });
  };
  return F(pu, { children: [
    x("button", { class: "icon more", ...r, "aria-label": `More of ${t}`, onPointerDown: (u) => a(u.currentTarget), onFocus: (u) => a(u.currentTarget), children: x(De, { name: "more" }) }),
    F("div", { id: n, popover: "auto", class: "menu", children: [
      F("label", { class: "line", children: [
        x("span", { children: "Name" }),
        x("span", { class: "field", children: x("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (u) => i("rename", { name: u.currentTarget.value }) }) })
      ] }),
      x("button", { class: "item", onClick: () => i("update"), children: x("span", { children: "Update to what is set now" }) }),
      x("button", { class: "item", onClick: () => i("recall", { seconds: 0 }), children: x("span", { children: "Recall at once" }) }),
      x(
        "button",
        {
          class: "item",
          onClick: () => {
            l(), au({ false_color: o ? null : ct(e) });
          },
          children: x("span", { children: o ? "End the difference" : "Difference to now" })
        }
      ),
      x("button", { class: "item", onClick: () => i("remove"), children: x("span", { children: "Remove" }) })
    ] })
  ] });
}
var Wo = () => Wn.value?.stage === "moving" || Wn.value?.stage === "refining" || Wn.value?.stage === "loading", Go = (e, t) => e == null ? "" : ` · Δ ${lu(e * t)}`;
function uu() {
  let e = nu.value;
  return F("section", { class: "readings", "aria-label": "Meters and grids", children: [
    F("header", { children: [
      x("h2", { children: "Meters" }),
      x("button", { class: "tab", onClick: () => Gn.value = "looks", children: "Looks" }),
      x("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => Dn("meter-tool"), children: x(De, { name: "meter" }) }),
      x("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => Dn("grid"), children: x(De, { name: "grid" }) }),
      x("button", { onClick: () => Dn("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      F("label", { class: "tint", title: "How high levels may be set, of each lamp's flux", children: [
        "up to",
        x(Bo, { label: "Highest level to reach targets", quantity: "level", value: $e.value, step: 0.1, set: (t) => $e.value = Math.min(10, Math.max(1, t($e.value))) })
      ] }),
      x("button", { onClick: Po, title: "Save all figures as CSV", children: "CSV" }),
      x("span", { class: "gap" }),
      x("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${On(e, 2)} maintained` })
    ] }),
    F("ul", { children: [
      Do.all().map(([t, n]) => {
        let a = n.lux, o = a?.[1] == null || a[1] > 0.02 * a[0] || Wo();
        return x("li", { children: F("button", { class: "reading", "aria-pressed": Gt.value?.kind === "meter" && Gt.value.ids.includes(t), onClick: () => Oo("meter", t), children: [
          F("span", { class: "tint", children: [
            x(De, { name: "meter" }),
            n.name
          ] }),
          x("strong", { class: o ? "unsettled" : "", children: a ? fe(a[0] * e) : "…" }),
          F("small", { children: [
            a?.[1] != null ? `±${fe(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind,
            Go(n.change, e),
            n.target ? ` · wants ${fe(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      Ho.all().map(([t, n]) => {
        let a = n.target, o = n.mean == null || n.error == null || n.error > 0.05 * n.mean || Wo(), r = a && n.mean != null && n.uniformity != null && n.mean * e >= a.lux && n.uniformity >= a.uniformity;
        return x("li", { children: F("button", { class: "reading", "aria-pressed": Gt.value?.kind === "grid" && Gt.value.ids.includes(t), onClick: () => Oo("grid", t), children: [
          F("span", { class: "tint", children: [
            x(De, { name: "grid" }),
            n.name,
            " ",
            a && n.mean != null && x("b", { class: r ? "met" : "missed", children: r ? "✓" : "✗" })
          ] }),
          x("strong", { class: o ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${fe(n.mean * e)}${n.error == null ? "" : ` ±${fe(n.error * e, !1)}`}` }),
          F("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : On(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : fe(n.min * e, !1),
            " to",
            " ",
            n.max == null ? "…" : fe(n.max * e, !1),
            Go(n.change, e),
            a ? ` · wants ${fe(a.lux)}, U₀ ${On(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !Do.ids.value.length && !Ho.ids.value.length && x("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function cu() {
  return F("div", { class: "strip-parts", "data-tab": Gn.value, children: [
    x(iu, {}),
    x(uu, {})
  ] });
}

// src/later/menus.tsx
import {
  camera as jo,
  digits as zo,
  display as mu,
  Field as Bt,
  go as Xo,
  houseLights as Kn,
  Item as Se,
  Range as du,
  show as Bn,
  theme as Uo,
  walking as hu
} from "./desk.js";
import { Fragment as Ut, jsx as S, jsxs as te } from "./desk.js";
var Kt = Math.PI / 360;
function _o(e) {
  let t = jo.peek();
  t && Xo({ ...t, fov: Math.max(3, Math.min(140, e)) });
}
function gu() {
  let e = jo.value, t = bt();
  return te(Ut, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((n) => S(Se, { id: n }, n)),
    S("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((n) => S(Se, { id: `preset-${n}` }, n)),
    S("hr", {}),
    t.length > 0 && S("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    t.map(({ name: n, camera: a }, o) => S("button", { class: "item", onClick: () => Xo(a, n), children: S("span", { children: n }) }, o)),
    t.length > 0 && S("hr", {}),
    e && !e.height && te(Ut, { children: [
      te("label", { class: "line", children: [
        S("span", { children: "Angle" }),
        S(Bt, { label: "Vertical angle of view", quantity: "angle", value: e.fov, step: 1, set: (n) => _o(n(e.fov)) })
      ] }),
      te("label", { class: "line", children: [
        S("span", { children: "Focal length" }),
        S(Bt, { label: "Focal length on 36 × 24 mm", quantity: "number", value: Math.round(120 / Math.tan(e.fov * Kt)) / 10, text: `${zo(12 / Math.tan(e.fov * Kt), 1)} mm`, step: 1, set: (n) => _o(Math.atan(12 / Math.max(2, n(12 / Math.tan(e.fov * Kt)))) / Kt) })
      ] }),
      S("hr", {})
    ] }),
    S(Se, { id: "walking", label: hu.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    S(Se, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((n) => S(Se, { id: `hands-${n}` }, n))
  ] });
}
var fu = ["linear", "reinhard", "filmic"];
function bu() {
  let e = mu.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return te(Ut, { children: [
    te("fieldset", { children: [
      S("legend", { children: "Tone curve" }),
      S("div", { class: "segments", children: fu.map((n) => S("button", { "aria-pressed": e.tone === n, onClick: () => Bn({ tone: n }), children: n }, n)) })
    ] }),
    te("fieldset", { children: [
      S("legend", { children: "White balance" }),
      te("label", { class: "line", children: [
        S("span", { children: "White" }),
        S(Bt, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => Bn({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      te("label", { class: "line", children: [
        S("span", { children: "Tint" }),
        S(Bt, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => Bn({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    S("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => S(Se, { id: n }, n))
  ] });
}
function vu() {
  return te(Ut, { children: [
    te("label", { class: "line", children: [
      S("span", { children: "House lights" }),
      S(du, { label: "House lights", value: Kn.value, text: `${zo(Kn.value * 100)} %`, on: (e) => Kn.value = Math.max(0.3, e) })
    ] }),
    S("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => S("button", { "aria-pressed": Uo.value === e, onClick: () => Uo.value = e, children: e }, e)) }),
    S("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => S(Se, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as _t, cut as yu, digits as Qo, edit as Yo, go as ku, Icon as rt, Range as wu, setCut as xu, signal as Mu, storeView as Su, viewName as Cu, views as $u } from "./desk.js";
import { jsx as W, jsxs as Un } from "./desk.js";
var jt = Mu(null);
function Lu() {
  let e = $u.all();
  return Un("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    W("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => _t("home"), children: W(rt, { name: "home" }) }),
    W("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => _t("frame"), children: W(rt, { name: "frame" }) }),
    W("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => _t("back"), children: W(rt, { name: "back" }) }),
    W("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => _t("forth"), children: W(rt, { name: "forth" }) }),
    W("span", { class: "divide" }),
    e.map(([t, n], a) => jt.value === t ? W("span", { class: "field", children: W(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (o) => o?.focus(),
        onBlur: (o) => {
          let r = o.currentTarget.value.trim();
          jt.value = null, r && r !== n.name && Yo(`Rename the view ${r}`, { views: { [t]: { ...n, name: r } } });
        },
        onKeyDown: (o) => {
          o.stopPropagation(), o.key === "Escape" && (o.currentTarget.value = n.name ?? ""), (o.key === "Enter" || o.key === "Escape") && o.currentTarget.blur();
        }
      }
    ) }, t) : Un(
      "button",
      {
        class: "saved-view",
        "aria-pressed": Cu.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click or F2 renames, Delete removes`,
        onClick: () => ku(n, n.name ?? "view"),
        onDblClick: () => jt.value = t,
        onKeyDown: (o) => {
          o.key === "F2" && (jt.value = t), o.key === "Delete" && (o.stopPropagation(), Yo(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          W("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    W("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: Su, children: W(rt, { name: "plus" }) })
  ] });
}
function Pu() {
  let e = yu.value;
  if (!e) return null;
  let t = e.height === null ? `${Qo(e.value, 2)} m` : `at ${Qo(e.height, 2)} m`;
  return Un("label", { class: "cut", "data-scroll": !0, children: [
    W("span", { children: "Cut" }),
    W(
      wu,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => xu(n * e.most)
      }
    ),
    W("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as Tu, useRef as Eu } from "./desk.js";
import { jsx as Zo } from "./desk.js";
function Vu() {
  let e = Eu(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let r = a.getBoundingClientRect(), l = (s) => Math.max(-1, Math.min(1, s)), i = o ? 0 : l((n.clientX - r.left) / (r.width / 2) - 1), u = o ? 0 : l(1 - (n.clientY - r.top) / (r.height / 2));
    e.current?.style.setProperty("transform", `translate(${i * 28}px, ${-u * 28}px)`), Tu(u, i);
  };
  return Zo("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: Zo("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as Jo,
  closeWhat as el,
  digits as Au,
  hovered as tl,
  Icon as Iu,
  lamps as qu,
  luxText as be,
  nameOf as Ru,
  select as Fu,
  useEffect as Hu,
  useRef as Nu,
  viewSize as Du,
  what as Ou
} from "./desk.js";
import { jsx as K, jsxs as ae } from "./desk.js";
var Ce = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], Wu = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function Gu() {
  let e = Ou.value, t = Nu(null);
  if (Hu(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = Du.value, o = [...e.lamps].sort((p, b) => Ce(b) - Ce(p)), r = o.reduce((p, b) => p + Ce(b), 0) || 1, l = o.slice(0, 9), i = r - l.reduce((p, b) => p + Ce(b), 0), u = Math.max(8, Math.min(e.x + 12, n - 332)), s = Math.max(8, Math.min(e.y + 12, a - 150 - 35 * l.length)), m = e.lux ? `${be(e.lux[0])} ±${be(e.lux[1], !1)}` : "Measuring…";
  return ae(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${u}px`, top: `${s}px` },
      onKeyDown: (p) => {
        p.key === "Escape" && (p.stopPropagation(), el(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        ae("header", { children: [
          K("strong", { class: e.done ? "" : "unsettled", children: m }),
          K("span", { class: "quiet", children: "what lights this" }),
          K("button", { class: "icon", "aria-label": "Close", onClick: el, children: K(Iu, { name: "close" }) })
        ] }),
        ae("ol", { children: [
          l.map((p) => K(
            "li",
            {
              onPointerEnter: () => tl.value = { kind: "lamp", id: p.id },
              onPointerLeave: () => tl.value = null,
              children: ae("button", { class: "row", onClick: () => Fu("lamp", p.id), children: [
                K("span", { class: "name", children: Ru("lamp", p.id) }),
                ae("span", { class: "figure", children: [
                  Au(100 * Ce(p) / r, Ce(p) / r < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                ae("span", { class: "figure lux", children: [
                  be(Ce(p)),
                  " ±",
                  be(Wu(p), !1)
                ] }),
                ae("span", { class: "shares", "aria-hidden": "true", children: [
                  K("i", { class: "direct", style: { width: `${100 * p.direct[0] / r}%` } }),
                  K("i", { class: "indirect", style: { width: `${100 * p.indirect[0] / r}%` } }),
                  K("i", { class: "caustic", style: { width: `${100 * p.caustic[0] / r}%` } })
                ] }),
                ae("span", { class: "spoken", children: [
                  "direct ",
                  be(p.direct[0]),
                  ", indirect ",
                  be(p.indirect[0]),
                  ", caustic",
                  " ",
                  be(p.caustic[0])
                ] })
              ] })
            },
            p.id
          )),
          o.length > l.length && ae("li", { class: "quiet", children: [
            o.length - l.length === 1 ? "one more" : `${o.length - l.length} more together`,
            ": ",
            be(i)
          ] }),
          !o.length && K("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        ae("footer", { children: [
          K("span", { class: "key direct", children: "direct" }),
          K("span", { class: "key indirect", children: "indirect" }),
          K("span", { class: "key caustic", children: "caustic" }),
          K("span", { class: "gap" }),
          Jo.value.some((p) => qu.get(p)?.place?.direction) && K("button", { onClick: () => _e(Jo.peek(), e.hit.point), children: "Aim here" }),
          K("button", { onClick: () => je(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  or as Compare,
  Pu as CutBar,
  Or as Gizmo,
  zi as Inspector,
  ls as Legend,
  vu as PageItems,
  bu as SeeingItems,
  Js as SheetHead,
  eu as SheetRow,
  Fs as Sheets,
  cu as Strip,
  gu as ViewItems,
  Lu as ViewStrip,
  Vu as WalkPad,
  Gu as What
};
