// src/later/actions.ts
import {
  adding as yl,
  asked as kl,
  ask as wl,
  back as xl,
  candles as ra,
  chosenLamps as pe,
  clearSolo as Ml,
  command as on,
  compareHeld as Sl,
  copyText as $l,
  deselect as Cl,
  each as rn,
  edit as sn,
  exposeBy as ia,
  falseColor as Ll,
  fine as sa,
  forth as Pl,
  frameSelection as Vl,
  go as Tl,
  goHome as El,
  goInside as Il,
  goPreset as Al,
  handles as ua,
  hands as Rl,
  here as ql,
  highlight as Fl,
  history as ca,
  lampMarks as pa,
  lamps as mt,
  listing as da,
  lookOnly as ma,
  panels as ha,
  PRESETS as Hl,
  register as Nl,
  say as dt,
  scene as Ol,
  selection as ka,
  send as Dl,
  sheet as ze,
  show as Wl,
  soloSelection as Gl,
  spot as Xe,
  startTool as ke,
  stepSelection as ga,
  storeLook as Kl,
  storeView as Bl,
  theme as ba,
  things as fa,
  titleOf as wa,
  toggleFalse as Ul,
  toggleWipe as _l,
  travel as va,
  views as jl,
  walking as ln,
  whyNot as Q
} from "./desk.js";

// src/later/tools.ts
import {
  add as Ce,
  adding as sl,
  chosenLamps as Jn,
  cross as ul,
  distance as cl,
  dot as Jt,
  edit as it,
  effect as pl,
  free as aa,
  grids as ea,
  lamps as Le,
  meters as ta,
  normal as en,
  onTool as dl,
  positionOf as ml,
  say as st,
  scale as ce,
  select as hl,
  step as tn,
  sub as ut,
  titleOf as ct,
  tool as ye,
  up as oa
} from "./desk.js";
var Ke = null;
pl(() => {
  ye.value !== "grid" && (Ke = null);
});
function gl(e) {
  if (!e) return st("There is nothing at that point.", "warn");
  switch (ye.peek()) {
    case "aim":
      Be(Jn.peek(), e.point), ye.value = null;
      break;
    case "place":
      bl(Jn.peek(), e), ye.value = null;
      break;
    case "meter":
      Ue(e.point, e.normal), ye.value = null;
      break;
    case "grid":
      if (!Ke) {
        Ke = e;
        return;
      }
      fl(Ke.point, e.point), Ke = null, ye.value = null;
      break;
    case "add":
      vl(sl.peek(), e), ye.value = null;
      break;
  }
}
dl(gl);
function Be(e, t) {
  let n = {};
  for (let a of e) {
    let o = Le.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: en(ut(t, o.position)) } });
  }
  if (!Object.keys(n).length) return st("What is selected shines into all directions: it cannot be aimed.", "warn");
  it(`Aim ${ct(e)}`, { lamps: n });
}
function nn(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let r = o.filter((l) => !n.has(l));
    r.length && (hl(t, r[r.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), 3e3);
}
function bl(e, t) {
  let n = je(e), a = n.get(e[e.length - 1]);
  if (!a) return st("What is selected has no place.", "warn");
  let o = (Le.get(e[e.length - 1])?.place?.radius ?? 0) + 0.02;
  it(`Put ${ct(e)} on a surface`, _e(e, ut(Ce(t.point, ce(t.normal, o)), a), n));
}
function Ue(e, t) {
  let n = aa(ta);
  nn(ta, "meter"), it("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function an(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
function fl(e, t, n = { lux: 500, uniformity: 0.6 }) {
  let a = oa.peek(), o = Math.abs(a[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], r = en(ul(a, o)), l = ut(t, e), [u, s] = [Jt(l, o), Jt(l, r)];
  if (Math.abs(u) < 0.05 || Math.abs(s) < 0.05) return st("An area needs two corners that lie apart.", "warn");
  let i = Ce(e, Ce(ce(o, Math.min(u, 0)), ce(r, Math.min(s, 0))));
  [u, s] = [Math.abs(u), Math.abs(s)];
  let p = (g) => Math.max(1, Math.ceil(g / an(Math.max(u, s)))), c = aa(ea);
  nn(ea, "grid"), it("Lay a grid", {
    grids: {
      [c]: {
        name: `Area ${c + 1}`,
        corner: i,
        u: ce(o, u),
        v: ce(r, s),
        normal: a,
        columns: p(u),
        rows: p(s),
        target: n
      }
    }
  });
}
var na = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function vl(e, t) {
  let n = oa.peek(), a = Jt(t.normal, n), o = a > 0.7 ? Ce(t.point, ce(n, 1.2)) : Ce(t.point, ce(t.normal, 0.15)), r = a > 0.7 || a < -0.7 ? ce(n, -1) : t.normal, l = { position: o };
  e !== "point" && e !== "sphere" && (l.direction = r), e === "spot" && Object.assign(l, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (l.radius = 0.15), e === "sphere" && (l.radius = 0.08);
  let u = Le.all().filter(([, s]) => s.own).length;
  nn(Le, "lamp"), tn(`Add ${na[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${na[e] ?? e} ${u + 1}`, kind: e, flux: 800, place: l }
  });
}
function pt(e, t, n) {
  !e.length || t < 1 || tn(`Copy ${ct(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function la(e) {
  e.length && tn(`Remove ${ct(e)}`, { do: "remove", lamps: e });
}
function _e(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = Le.get(o)?.place, l = n.get(o);
    if (!l) continue;
    let u = Ce(l, t), s = r?.aim && cl(r.aim, u) > 1e-6 ? { direction: en(ut(r.aim, u)) } : {};
    a[o] = { place: { position: u, ...s } };
  }
  return { lamps: a };
}
function je(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = Le.get(n), o = a && ml(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/actions.ts
var ae = () => Q() ?? (pe.value.length ? null : "Select a lamp first.");
function zl() {
  let e = pe.peek(), t = !e.some((n) => mt.get(n)?.on);
  sn(`${wa(e)} ${t ? "on" : "off"}`, { lamps: rn(e, { on: t }) });
}
function Xl() {
  let e = pe.peek(), t = !e.every((n) => mt.get(n)?.parked);
  sn(`${t ? "Park" : "Unpark"} ${wa(e)}`, { lamps: rn(e, { parked: t }) });
}
function ya(e) {
  let t = ka.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : fa.ids.peek().filter((a) => fa.get(a)?.hidden);
  if (!n.length) return dt(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  sn(e ? "Hide things" : "Show hidden things", { things: rn(n, { hidden: e }) });
}
function Ql() {
  let e = pe.peek()[0], t = mt.get(e)?.place, n = ql();
  if (!t?.position || !t.direction || !n) return dt("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  Tl({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function Yl() {
  wl("command", {}, (e) => {
    $l(e.text);
  });
}
var Zl = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Jl = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, er = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: Vl },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: El },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: Il },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: xl },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: Pl },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Bl, why: Q },
  ...Hl.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Jl[e],
    keys: `Shift+${t + 1}`,
    run: () => Al(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      ln.value = ln.peek() === "walk" ? "fly" : "walk", dt(ln.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: Ql, why: ae },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => ga(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => ga(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => ke("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => ka.value = { kind: "lamp", ids: mt.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: Cl },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: zl, why: ae },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Gl, why: () => pe.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: Ml },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => Fl(!0), why: ae },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Xl, why: ae },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => ke("aim"), why: ae },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => Xe.peek() && Be(pe.peek(), Xe.peek().point), why: ae },
  { id: "place", group: "Lamps", label: "Put on a surface by pointing", keys: "Shift+N", run: () => ke("place"), why: ae },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => ua.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => ua.value = "turn" },
  ...Zl.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: Q,
    run: () => {
      yl.value = e, ke("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => pt(pe.peek(), 1, [0.5, 0, 0]), why: ae },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => la(pe.peek()), why: ae },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => ya(!0), why: Q },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => ya(!1), why: Q },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => on({ do: "undo" }), why: () => Q() ?? (ca.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => on({ do: "redo" }), why: () => Q() ?? (ca.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => ze.value = "save", why: Q },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => ze.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Yl },
  { id: "share", group: "Work", label: "Share by link", run: () => ze.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: Ul },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = Ll();
      Wl({ false_color: { ...kl(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => ia(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => ia(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => Dl({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => Sl(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: _l },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: Q, run: () => Xe.peek() ? Ue(Xe.peek().point, Xe.peek().normal) : ke("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => ke("meter"), why: Q },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => ke("grid"), why: Q },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => on({ do: "reach" }), why: Q },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => ra.value = ra.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Kl, why: Q },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => dt("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => ha.value = !ha.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => da.value = da.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => va.value = va.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => pa.value = !pa.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => sa.value = !sa.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => ba.value = ba.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => ma.value = !ma.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => Rl.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => ze.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => ze.value = "palette" }
];
Nl(er);
function ht() {
  return [...(Ol.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...jl.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as tr, comparing as nr, digits as ar, fitted as or, useEffect as lr, useRef as rr, viewSize as ir, wipeAt as un } from "./desk.js";
import { Fragment as ur, jsx as cn, jsxs as cr } from "./desk.js";
function sr() {
  let e = nr.value, t = tr.value, n = rr(null);
  if (lr(() => {
    let i = n.current;
    !i || !t || (i.width = t.picture.width, i.height = t.picture.height, i.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = ir.value, o = un.value, r = or(t.picture.width, t.picture.height), l = Math.max(0, Math.min(1, (o * a - r.x) / (t.picture.width * r.scale))), u = (i) => {
    let p = i.currentTarget;
    if (i.stopPropagation(), i.type === "pointerdown") p.setPointerCapture(i.pointerId);
    else if (p.hasPointerCapture(i.pointerId)) {
      let c = p.parentElement.getBoundingClientRect();
      un.value = Math.max(0, Math.min(1, (i.clientX - c.left) / c.width));
    }
  }, s = (i) => {
    let p = { ArrowLeft: -0.02, ArrowRight: 0.02 }[i.key];
    p && (i.stopPropagation(), i.preventDefault(), un.value = Math.max(0, Math.min(1, o + p)));
  };
  return cr(ur, { children: [
    cn(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * l}% 0 0)` : "none" }
      }
    ),
    cn("span", { class: "tag left", children: "before" }),
    e === "wipe" && cn(
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
        "aria-valuetext": `${ar(o * 100)} % before`,
        style: { left: `${100 * o}%` },
        onPointerDown: u,
        onPointerMove: u,
        onKeyDown: s
      }
    )
  ] });
}

// src/later/handles.tsx
import {
  add as La,
  chosenLamps as yr,
  computed as mn,
  editor as kr,
  effect as wr,
  fitted as xr,
  Gesture as Mr,
  handles as Sr,
  lamps as bt,
  lookOnly as $r,
  middle as Cr,
  nameOf as Lr,
  normal as Pr,
  pinhole as Vr,
  positionOf as Va,
  role as Tr,
  selection as Er,
  shown as Ir,
  sub as Ar,
  things as ft,
  titleOf as Rr,
  tool as qr,
  turn as Pa,
  useEffect as Fr,
  useRef as Hr,
  viewSize as Nr
} from "./desk.js";

// src/later/gizmo.ts
import { project as xa, ray as pr } from "./desk.js";
import { across as dr, add as oe, cross as mr, distance as hr, dot as de, length as gr, normal as pn, scale as le, sub as Pe } from "./desk.js";
var br = "http://www.w3.org/2000/svg", dn = 84, we = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], gt = ["x", "y", "z"], Ma = 0.1, fr = 5 * Math.PI / 180, Sa = 48;
function Ca(e, t) {
  let n = (m, b, k) => {
    let w = document.createElementNS(br, m);
    return w.setAttribute("class", k), b.append(w), w;
  }, a = (m, b, k) => {
    let w = n("g", e, `handle ${m} ${gt[b] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), r = we.map((m, b) => a("ring", b, `ring-${gt[b]}`)), l = we.map((m, b) => a("plane", b, `plane-${gt[b]}`)), u = we.map((m, b) => a("arrow", b, `move-${gt[b]}`)), s = a("centre", -1, "move-view"), i = a("aim", -1, "aim"), p = n("text", e, "handle-text"), c = (m, b) => {
    let [k, w, V] = xa(m.hole, b);
    return V < 0.02 && !m.hole.parallel ? null : [m.fit.x + k * m.fit.scale, m.fit.y + w * m.fit.scale];
  }, g = (m, b) => {
    let k = xa(m.hole, b)[2];
    return dn / m.fit.scale * m.hole.pixel * (m.hole.parallel ? 1 : Math.max(k, 0.02));
  }, d = (m, b, k = !1) => {
    let w = b.filter((C) => C !== null), V = w.length < b.length || w.length < 2 ? "" : `M${w.map((C) => `${C[0].toFixed(1)} ${C[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    m.setAttribute("d", V);
  }, v = (m, b, k) => {
    m.setAttribute("d", b ? `M${b[0] - k} ${b[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, y = (m, b) => m.forEach((k) => k.group.classList.toggle("gone", !b));
  function E(m, b) {
    let k = m.position, w = c(b, k), V = g(b, k), C = m.mode === "move";
    y([...u, ...l, s], C && w !== null), y(r, !C && w !== null && m.turns);
    let j = m.aim ?? (m.direction ? oe(k, le(m.direction, 3 * V)) : null);
    if (y([i], j !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    we.forEach((W, U) => {
      let R = c(b, oe(k, le(W, V))), ot = R ? Math.hypot(R[0] - w[0], R[1] - w[1]) < 12 : !0;
      if (u[U].group.classList.toggle("gone", !C || ot), R && C) {
        let [ve, We] = [(R[0] - w[0]) / dn, (R[1] - w[1]) / dn], rt = Math.hypot(ve, We) || 1, [ue, Ge] = [ve / rt, We / rt], Zt = [w[0] + 14 * ue, w[1] + 14 * Ge];
        d(u[U].hit, [Zt, R]), u[U].seen.setAttribute("d", `M${Zt[0].toFixed(1)} ${Zt[1].toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}M${(R[0] - 9 * ue - 4.5 * Ge).toFixed(1)} ${(R[1] - 9 * Ge + 4.5 * ue).toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}L${(R[0] - 9 * ue + 4.5 * Ge).toFixed(1)} ${(R[1] - 9 * Ge - 4.5 * ue).toFixed(1)}`);
      }
      let [Oe, De] = [we[(U + 1) % 3], we[(U + 2) % 3]], Z = Math.abs(de(W, b.hole.parallel ? b.hole.forward : pn(Pe(k, b.hole.eye)))) < 0.15;
      l[U].group.classList.toggle("gone", !C || Z);
      let lt = (ve, We) => c(b, oe(k, oe(le(Oe, ve * V), le(De, We * V)))), Zn = [lt(0.3, 0.3), lt(0.5, 0.3), lt(0.5, 0.5), lt(0.3, 0.5)];
      if (d(l[U].hit, Zn, !0), d(l[U].seen, Zn, !0), !C) {
        let ve = Array.from({ length: Sa + 1 }, (We, rt) => {
          let ue = 2 * Math.PI * rt / Sa;
          return c(b, oe(k, oe(le(Oe, Math.cos(ue) * V), le(De, Math.sin(ue) * V))));
        });
        d(r[U].hit, ve), d(r[U].seen, ve);
      }
    }), v(s.hit, w, 13), v(s.seen, w, 7);
    let A = j && c(b, j);
    d(o, [w, A]), v(i.hit, A, 16), i.seen.setAttribute("d", A ? `M${A[0] - 8} ${A[1]}h16M${A[0]} ${A[1] - 8}v16M${A[0] - 5} ${A[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let D = t.effect(() => {
    let m = t.target.value, b = t.view.value;
    e.classList.toggle("empty", !m || !b), m && b && E(m, b);
  }), Xn = (m, b, k) => pr(m.hole, (b.clientX - k.left - m.fit.x) / m.fit.scale, (b.clientY - k.top - m.fit.y) / m.fit.scale);
  function Ne(m, b, k) {
    m.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let V = t.view.peek();
      if (!V || !t.target.peek()) return;
      let C = e.getBoundingClientRect(), j = k(V), A = t.hold(b), W = Xn(V, w, C);
      j(W, !1, { ...A, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), m.setPointerCapture(w.pointerId), m.classList.add("held");
      let U = (Z) => {
        p.textContent = j(Xn(V, Z, C), Z.ctrlKey || Z.metaKey, A), p.setAttribute("x", String(Z.clientX - C.left + 16)), p.setAttribute("y", String(Z.clientY - C.top - 12));
      }, R = (Z) => {
        m.removeEventListener("pointermove", U), m.removeEventListener("pointerup", ot), m.removeEventListener("pointercancel", Oe), removeEventListener("keydown", De, !0), m.classList.remove("held"), p.textContent = "", Z ? A.end() : A.cancel();
      }, ot = () => R(!0), Oe = () => R(!1), De = (Z) => {
        Z.key === "Escape" && (Z.stopPropagation(), R(!1));
      };
      m.addEventListener("pointermove", U), m.addEventListener("pointerup", ot), m.addEventListener("pointercancel", Oe), addEventListener("keydown", De, !0);
    });
  }
  let Qt = (m, b, k) => k ? Math.round(m / b) * b : m, Yt = (m) => m.map((b) => b.toFixed(2)).join("  ") + " m";
  we.forEach((m, b) => {
    Ne(u[b].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (V, C, j) => {
        let A = vr(k, m, V);
        w ??= A;
        let W = le(m, Qt(A - w, Ma, C));
        return j.move(W), Yt(W);
      };
    }), Ne(l[b].group, "move", () => Qn(m)), Ne(r[b].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (V, C, j) => {
        let A = $a(k.position, m, V), W = A && pn(Pe(A, k.position), dr(m));
        if (!W) return "";
        w.at ??= W;
        let U = Math.atan2(de(m, mr(w.at, W)), de(w.at, W)), R = Qt(U, fr, C);
        return j.rotate(m, R), `${(R * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), Ne(s.group, "move", (m) => Qn(m.hole.forward)), Ne(i.group, "aim", (m) => {
    let b = t.target.peek(), k = b.aim ?? oe(b.position, le(b.direction, 3 * g(m, b.position))), w = Yn(k, m.hole.forward);
    return (V, C, j) => {
      let A = w(V, C), W = oe(k, A);
      return hr(W, b.position) > 1e-3 && j.turn(pn(Pe(W, b.position)), W), Yt(W);
    };
  });
  function Qn(m) {
    let b = Yn(t.target.peek().position, m);
    return (k, w, V) => {
      let C = b(k, w);
      return V.move(C), Yt(C);
    };
  }
  function Yn(m, b) {
    let k = null;
    return (w, V) => {
      let C = $a(m, b, w);
      return C ? (k ??= C, Pe(C, k).map((j) => Qt(j, Ma, V))) : [0, 0, 0];
    };
  }
  return { stop: D };
}
function vr(e, t, n) {
  let a = Pe(e, n.origin), o = de(t, n.direction), r = 1 - o * o;
  return r < 1e-6 ? 0 : (o * de(n.direction, a) - de(t, a)) / r;
}
function $a(e, t, n) {
  let a = de(t, n.direction);
  if (Math.abs(a) < 1e-4 * gr(t)) return null;
  let o = de(Pe(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : oe(n.origin, le(n.direction, o));
}

// src/later/handles.tsx
import { jsx as Ur } from "./desk.js";
function Or([e, t, n, a], [o, r, l, u]) {
  return [
    a * o + e * u + t * l - n * r,
    a * r - e * l + t * u + n * o,
    a * l + e * r - t * o + n * u,
    a * u - e * o - t * r - n * l
  ];
}
var Dr = () => !$r.value && Tr.value !== "watch" && kr.value.you && qr.value !== "aim", Ta = mn(() => {
  let e = Er.value;
  if (!e || !Dr()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => ft.get(a) && !ft.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = yr.value.filter((n) => Va(bt.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), Ea = (e) => {
  let t = ft.get(e);
  return t?.place?.position ?? (t?.box ? Cr(t.box) : null);
}, Wr = mn(() => {
  let e = Ta.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? Va(bt.get(t)) : Ea(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? bt.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: Sr.value
  };
}), Gr = mn(() => {
  let e = Ir.value;
  if (Nr.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: Vr(e.camera, t, n), fit: xr(t, n) };
}), Kr = {
  effect: wr,
  target: Wr,
  view: Gr,
  hold(e) {
    let t = Ta.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? Rr(n) : n.length === 1 ? Lr("thing", n[0]) : `${n.length} things`, r = new Mr(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), l = a === "lamps" ? je(n) : new Map(n.map((i) => [i, Ea(i)])), u = new Map(n.map((i) => [i, (a === "lamps" ? bt : ft).get(i)?.place])), s = (i) => {
      let p = n.map((c) => [c, i(c)]).filter(([, c]) => c);
      r.set({ [a]: Object.fromEntries(p.map(([c, g]) => [c, { place: g }])) });
    };
    return {
      move: (i) => a === "lamps" ? r.set(_e(n, i, l)) : s((p) => ({ position: La(l.get(p), i) })),
      turn: (i, p) => s((c) => u.get(c)?.direction ? { direction: i, ...p ? { aim: p } : {} } : null),
      rotate: (i, p) => s((c) => {
        let g = u.get(c);
        if (g?.direction) {
          let y = Pr(Pa(g.direction, i, p)), E = g.aim && g.position ? Pa(Ar(g.aim, g.position), i, p) : null;
          return { direction: y, ...E ? { aim: La(g.position, E) } : {} };
        }
        let d = Math.sin(p / 2), v = [i[0] * d, i[1] * d, i[2] * d, Math.cos(p / 2)];
        return { rotation: Or(v, g?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => r.end(),
      cancel: () => r.cancel()
    };
  }
};
function Br() {
  let e = Hr(null);
  return Fr(() => Ca(e.current, Kr).stop, []), Ur("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as Eo, deselect as Xi, Icon as qn, penless as Fn, selection as Qi, signal as Yi } from "./desk.js";

// src/later/measure.tsx
import {
  deselect as Ga,
  digits as xe,
  edit as Mt,
  grids as Zr,
  Icon as Ka,
  length as Ee,
  luxText as Ie,
  maintenance as fn,
  meters as Jr,
  selection as Ba
} from "./desk.js";

// src/later/figures.tsx
import { maintenance as Aa, status as hn } from "./desk.js";

// src/later/verdict.ts
function Ia(e, t) {
  let n = ({ value: o, error: r, least: l }) => {
    let u = t ? 0 : r ?? 1 / 0;
    return o - u >= l ? "met" : o + u < l ? "missed" : "open";
  }, a = e.map(n);
  return a.includes("missed") ? "missed" : a.includes("open") ? "open" : "met";
}

// src/later/figures.tsx
import { jsx as Oa } from "./desk.js";
var Ra = () => hn.value?.stage === "moving" || hn.value?.stage === "loading", _r = () => Ra() || hn.value?.stage === "refining", qa = { meter: 0.02, grid: 0.05 };
function Fa(e, t, n) {
  return e == null || t == null || t > n * e || _r();
}
var vt = ({ lux: e }) => Fa(e?.[0], e?.[1], qa.meter), yt = ({ mean: e, error: t }) => Fa(e, t, qa.grid), Ha = (e, t) => Ra() ? "open" : Ia(e, t === !0);
function kt({ lux: e, target: t, done: n }) {
  if (!e || !t) return null;
  let a = Aa.value;
  return Ha([{ value: e[0] * a, error: e[1] == null ? null : e[1] * a, least: t }], n);
}
function wt({ mean: e, error: t, uniformity: n, uniformity_error: a, target: o, done: r }) {
  if (!o || e == null || n == null) return null;
  let l = Aa.value;
  return Ha([
    { value: e * l, error: t == null ? null : t * l, least: o.lux },
    { value: n, error: a ?? null, least: o.uniformity }
  ], r);
}
var Na = {
  met: ["✓", "reaches its target"],
  missed: ["✗", "misses its target"],
  open: ["≈", "within its ± of the target: not decided yet"]
};
function gn({ of: e }) {
  if (!e) return null;
  let [t, n] = Na[e];
  return Oa("b", { class: e, role: "img", "aria-label": n, title: n, children: t });
}
function bn({ of: e }) {
  if (!e) return null;
  let [t, n] = Na[e];
  return Oa("p", { class: e, children: `${t} ${n[0].toUpperCase()}${n.slice(1)}` });
}

// src/later/parts.tsx
import { Field as Da, Gesture as jr, Range as zr, stroke as Xr, useRef as Qr } from "./desk.js";
import { jsx as re, jsxs as xt } from "./desk.js";
function q({ title: e, note: t, children: n }) {
  return xt("section", { class: "part", "aria-label": e, children: [
    xt("h3", { children: [
      e,
      t && re("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function K(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function I(e) {
  return xt("label", { class: "line", children: [
    re("span", { children: e.label }),
    re(Da, { ...e, label: e.name ?? e.label })
  ] });
}
function Yr(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function J({ label: e, names: t, quantity: n, value: a, set: o, step: r, disabled: l }) {
  let u = t ?? ["X", "Y", "Z"];
  return xt("div", { class: "line", role: "group", "aria-label": e, children: [
    re("span", { children: e }),
    re("span", { class: "triple", children: u.map((s, i) => re(
      Da,
      {
        label: `${e} ${s}`,
        quantity: n,
        value: a[i],
        text: Yr(a[i], n),
        step: r,
        disabled: l,
        set: (p) => o(i, p)
      },
      s
    )) })
  ] });
}
function Ve({ label: e, name: t, value: n, text: a, patch: o, reset: r, notch: l, class: u, style: s, disabled: i }) {
  let p = Qr(null), c = (d) => () => {
    p.current?.[d](), p.current = null;
  }, g = (d) => p.current ? p.current.set(o(d)) : Xr(e + t, t, o(d));
  return re(
    zr,
    {
      label: e,
      value: n,
      text: a,
      notch: l,
      class: u,
      gradient: s,
      disabled: i,
      begin: () => p.current = new jr(t),
      on: g,
      end: c("end"),
      cancel: c("cancel"),
      reset: r === void 0 ? void 0 : () => g(r)
    }
  );
}
function Te({ value: e, label: t, set: n }) {
  return re("span", { class: "field name-field", children: re(
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
var ie = (e, t, n) => e.map((a, o) => o === t ? n(a) : a);

// src/later/measure.tsx
import { Fragment as vn, jsx as $, jsxs as _ } from "./desk.js";
var ei = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function Ua() {
  let e = Ba.value?.ids[0], t = Jr.get(e);
  if (!t) return $("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: r, done: l, ...u } = { ...t, ...o };
    Mt(`${t.name}: ${a}`, { meters: { [e]: u } });
  };
  return _(vn, { children: [
    $("header", { class: "panel-head", children: $(Te, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    $("p", { class: `crumbs ${vt(t) ? "unsettled" : "known"}`, children: t.lux?.[1] != null ? `${Ie(t.lux[0] * fn.value)} ±${Ie(t.lux[1] * fn.value, !1)}` : "measuring" }),
    $("div", { class: "scroll", children: _(q, { title: "Meter", children: [
      _("label", { class: "line", children: [
        $("span", { children: "Measures" }),
        $("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: ei.map(([a, o]) => $("option", { value: a, children: o }, a)) })
      ] }),
      $(J, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: ie(t.point, a, o) }) }),
      $(I, { label: "At least", quantity: "lux", step: 50, value: t.target ?? 0, set: (a) => n("target", { target: a(t.target ?? 0) || null }) }),
      $(bn, { of: kt(t) }),
      $(J, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: ie(t.normal, a, o) }) }),
      _("button", { class: "plain full", onClick: () => {
        Ga(), Mt(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        $(Ka, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var Wa = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function _a() {
  let e = Ba.value?.ids[0], t = Zr.get(e);
  if (!t) return $("p", { class: "quiet empty", children: "This grid is gone." });
  let n = fn.value, a = (s, i) => {
    let { name: p, corner: c, u: g, v: d, normal: v, columns: y, rows: E, target: D } = { ...t, ...i };
    Mt(`${t.name}: ${s}`, { grids: { [e]: { name: p, corner: c, u: g, v: d, normal: v, columns: y, rows: E, target: D } } });
  }, o = () => {
    let s = an(Math.max(Ee(t.u), Ee(t.v)));
    a("standard spacing", { columns: Math.max(1, Math.ceil(Ee(t.u) / s)), rows: Math.max(1, Math.ceil(Ee(t.v) / s)) });
  }, r = (s, i, p) => _(vn, { children: [
    $("dt", { children: s }),
    $("dd", { children: i == null ? "…" : p(i) })
  ] }), l = (s, i) => s == null ? "" : ` ±${i(s)}`, u = t.target ?? { lux: 500, uniformity: 0.6 };
  return _(vn, { children: [
    $("header", { class: "panel-head", children: $(Te, { label: "Name of the grid", value: t.name, set: (s) => a("rename", { name: s }) }) }),
    _("p", { class: "crumbs", children: [
      xe(Ee(t.u), 2),
      " × ",
      xe(Ee(t.v), 2),
      " m, ",
      xe(t.columns * t.rows),
      " points"
    ] }),
    _("div", { class: "scroll", children: [
      $(q, { title: "Figures", note: n === 1 ? "new" : `× ${xe(n, 2)}`, children: _("dl", { class: `figures ${yt(t) ? "unsettled" : ""}`, children: [
        r("Ē", t.mean, (s) => Ie(s * n) + l(t.error, (i) => Ie(i * n, !1))),
        r("E min", t.min, (s) => Ie(s * n)),
        r("E max", t.max, (s) => Ie(s * n)),
        r("U₀ = min / mean", t.uniformity, (s) => xe(s, 2) + l(t.uniformity_error, (i) => xe(i, 2))),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (s) => xe(s, 2))
      ] }) }),
      _(q, { title: "Target", children: [
        $(bn, { of: wt(t) }),
        _("label", { class: "line", children: [
          $("span", { children: "Class" }),
          _("select", { "aria-label": "Class of the target", value: "", onChange: (s) => {
            let i = Wa[Number(s.currentTarget.value)];
            a("target", { target: i ? { lux: i[1], uniformity: i[2] } : null });
          }, children: [
            $("option", { value: "", children: t.target ? "choose…" : "none" }),
            Wa.map(([s, i, p], c) => _("option", { value: c, children: [
              s,
              ": ",
              i,
              " lx, U₀ ",
              p
            ] }, s)),
            $("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        $(I, { label: "Ē at least", quantity: "lux", step: 50, value: u.lux, set: (s) => a("target", { target: { ...u, lux: s(u.lux) } }) }),
        $(I, { label: "U₀ at least", quantity: "share", step: 0.05, value: u.uniformity, set: (s) => a("target", { target: { ...u, uniformity: s(u.uniformity) } }) })
      ] }),
      _(q, { title: "Area", children: [
        $(J, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (s, i) => a("move", { corner: ie(t.corner, s, i) }) }),
        $(I, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (s) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(s(t.columns)))) }) }),
        $(I, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (s) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(s(t.rows)))) }) }),
        $("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: o, children: "Spacing of the standard" }),
        _("button", { class: "plain full", onClick: () => {
          Ga(), Mt(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          $(Ka, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as he,
  chosenLamps as hi,
  dot as Mn,
  edit as Ct,
  format as ao,
  groups as Lt,
  handles as St,
  Icon as Re,
  lamps as Ln,
  layers as gi,
  lumensOf as bi,
  normal as oo,
  output as fi,
  percent as Cn,
  positionOf as Ya,
  selection as Sn,
  signal as lo,
  spot as vi,
  sub as Za,
  titleOf as Pn,
  tool as ro,
  toLevel as Ja,
  toTravel as yi,
  typeLevel as $n,
  up as ki,
  Fade as wi,
  Field as xi,
  wantLevel as eo,
  compass as io,
  add as Pt,
  scale as qe,
  length as Mi,
  Range as Si,
  strokeLevel as to,
  useRef as $i
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as oi,
  digits as za,
  edit as li,
  fromHex as ri,
  hex as ii,
  lamps as Xa,
  mired as Me,
  titleOf as si
} from "./desk.js";

// src/later/white.ts
import { css as ti, mired as yn } from "./desk.js";
function ni(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((r) => Math.max(0, r));
}
function ai(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function ja(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, r) => {
    let l = yn(e) + (yn(t) - yn(e)) * r / (n - 1);
    return ti(ni(...ai(1e6 / l)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as wn, jsx as N, jsxs as me } from "./desk.js";
var Qe = 1800, xn = 1e4, ui = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], ci = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], pi = ja(Qe, xn), kn = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(Xa.get(n).color) }]))
}), di = (e) => {
  let t = 1e6 / (Me(Qe) + (Me(xn) - Me(Qe)) * e);
  return Math.round(t / 10) * 10;
}, mi = (e) => (Me(e) - Me(Qe)) / (Me(xn) - Me(Qe));
function Qa() {
  let e = oi.value, t = e.map((l) => Xa.get(l)?.color).filter((l) => l !== void 0);
  if (!t.length) return null;
  let n = K(t.map((l) => l.mode)), a = t[0], o = si(e), r = (l, u) => li(`${o}: ${l}`, kn(e, u));
  return me(wn, { children: [
    me("div", { class: "line", children: [
      N("span", { children: "Colour" }),
      N("div", { class: "segments", role: "group", "aria-label": "Colour by", children: ci.map(([l, u]) => N("button", { "aria-pressed": n === l, onClick: () => r(`colour by ${u}`, () => ({ mode: l })), children: u }, l)) })
    ] }),
    n === "kelvin" && me(wn, { children: [
      me("div", { class: "line slide", children: [
        N("span", { children: "White" }),
        N(
          Ve,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: pi,
            value: mi(a.kelvin),
            text: `${za(a.kelvin)} kelvin`,
            patch: (l) => kn(e, () => ({ mode: "kelvin", kelvin: di(l) }))
          }
        )
      ] }),
      N(
        I,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: K(t.map((l) => l.kelvin)),
          step: 50,
          set: (l) => r("white", (u) => ({ mode: "kelvin", kelvin: l(u.kelvin) }))
        }
      ),
      N("div", { class: "whites", role: "group", "aria-label": "Whites", children: ui.map(([l, u]) => N("button", { title: u, "aria-label": `${l} kelvin, ${u}`, onClick: () => r(`${l} K`, () => ({ mode: "kelvin", kelvin: l })), children: l }, l)) }),
      me("div", { class: "line slide", children: [
        N("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        N(
          Ve,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${za(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (l) => kn(e, () => ({ tint: Math.round((l * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      N(I, { label: "", name: "Tint, typed", quantity: "number", value: K(t.map((l) => l.tint)), step: 1, set: (l) => r("tint", (u) => ({ tint: Math.max(-50, Math.min(50, l(u.tint))) })) })
    ] }),
    n === "rgb" && me(wn, { children: [
      me("label", { class: "line", children: [
        N("span", { children: "Colour" }),
        N("input", { type: "color", class: "pick", "aria-label": "Colour", value: ii(a.rgb), onChange: (l) => r("colour", () => ({ mode: "rgb", rgb: ri(l.currentTarget.value) })) })
      ] }),
      N(
        J,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (l, u) => r("colour", (s) => ({ rgb: s.rgb.map((i, p) => p === l ? Math.max(0, u(i)) : i) }))
        }
      )
    ] }),
    n === "xy" && me("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      N("span", { children: "x, y" }),
      N("span", { class: "triple", children: [0, 1].map((l) => N(
        I,
        {
          label: "xy"[l],
          quantity: "number",
          step: 1e-3,
          value: K(t.map((u) => u.xy[l])),
          set: (u) => r("chromaticity", (s) => ({ xy: s.xy.map((i, p) => p === l ? Math.max(0.01, Math.min(0.9, u(i))) : i) }))
        },
        l
      )) })
    ] }),
    n === null && N("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as Vn, jsx as f, jsxs as O } from "./desk.js";
var Ae = lo(1), $t = lo([1, 0, 0]), Ci = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], Vt = 180 / Math.PI;
function no(e, t) {
  let { right: n, ahead: a } = io(t), o = -Mn(e, t);
  return [Math.atan2(Mn(e, n), Mn(e, a)) * Vt, Math.asin(Math.max(-1, Math.min(1, o))) * Vt];
}
function Li(e, t, n) {
  let { right: a, ahead: o } = io(n), [r, l] = [e / Vt, t / Vt], u = Pt(qe(a, Math.sin(r)), qe(o, Math.cos(r)));
  return oo(Pt(qe(u, Math.cos(l)), qe(n, -Math.sin(l))));
}
function Pi({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction);
  return O("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    O("button", { "aria-pressed": ro.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => he("aim"), children: [
      f(Re, { name: "aim" }),
      "Aim"
    ] }),
    f("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => he("solo"), children: f(Re, { name: "solo" }) }),
    f("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => he("from-lamp"), children: f(Re, { name: "eye" }) }),
    f("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => he("frame"), children: f(Re, { name: "frame" }) }),
    f("span", { class: "gap" }),
    f("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => he("park"), children: "Park" }),
    f("button", { class: "icon", "aria-label": `Remove ${Pn(e)}`, title: "Remove (Del)", onClick: () => he("remove"), children: f(Re, { name: "bin" }) })
  ] });
}
function Vi({ ids: e, all: t }) {
  let n = K(t.map((l) => l.level)), a = bi(e), o = t.every((l) => l.free), r = e[e.length - 1];
  return O(q, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    O("div", { class: "line slide", children: [
      f("span", { children: "Level" }),
      f(Ti, { id: r })
    ] }),
    O("label", { class: "line", children: [
      f("span", {}),
      f(
        xi,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: K(t.map((l) => l.flux)) ?? void 0,
          step: 0.01,
          set: (l) => $n(e, l),
          open: eo.value,
          opened: () => eo.value = "",
          id: "level"
        }
      )
    ] }),
    f(
      I,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (l) => $n(e, (u, s) => l(u * s) / s)
      }
    ),
    O("div", { class: "line", children: [
      f("span", { children: "Stops" }),
      f("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: Ci.map(([l, u]) => f("button", { "aria-label": `${u} stop`, onClick: () => $n(e, (s) => Math.min(1e3, s * 2 ** l)), children: u }, u)) })
    ] }),
    O("p", { class: "sum", children: [
      ao(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (Lt.get(t[0].group)?.level ?? 1) !== 1 && ` (${Cn(t[0].level)} % × ${Cn(Lt.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    f(Qa, {})
  ] });
}
function Ti({ id: e }) {
  let t = $i(null), n = Ln.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (r) => () => {
    t.current?.[r](), t.current = null;
  };
  return f(
    Si,
    {
      label: "Level",
      value: yi(n.level),
      text: `${Cn(n.level)} %, ${ao(n.flux * fi(n), "flux")}`,
      begin: () => t.current = new wi(a),
      on: (r) => t.current ? t.current.to(Ja(r)) : to(a, Ja(r)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => to(a, 1)
    }
  );
}
function Ye(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = Ln.get(o), l = n(r.place ?? {}, r);
    l && (a[o] = { place: l });
  }
  Object.keys(a).length && Ct(`${Pn(e)}: ${t}`, { lamps: a });
}
function Ei({ ids: e, all: t }) {
  let n = (o) => K(t.map((r) => r.place?.[o] ?? null)), a = (o) => t.some((r) => r.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : O(q, { title: "Beam", note: "re-trace", children: [
    a("outer") && O(Vn, { children: [
      f(I, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => Ye(e, "beam", (r) => r.outer == null ? null : { inner: Math.max(0.1, Math.min(r.outer, o(r.inner ?? r.outer))) }) }),
      f(I, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => Ye(e, "beam", (r) => {
        if (r.outer == null) return null;
        let l = Math.max(0.2, Math.min(179, o(r.outer)));
        return { outer: l, inner: Math.min(r.inner ?? l, l) };
      }) })
    ] }),
    a("radius") && f(I, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => Ye(e, "radius", (r) => r.radius == null ? null : { radius: Math.max(1e-3, o(r.radius)) }) })
  ] });
}
function Ii({ ids: e, all: t }) {
  let n = t.filter((c) => Ya(c) !== null);
  if (!n.length) return null;
  let a = n.map((c) => Ya(c)), o = (c, g) => K(g.map((d) => Math.round(d[c] * 1e4) / 1e4)), r = t.filter((c) => c.place?.direction), l = ki.value, u = r.map((c) => no(c.place?.direction, l).map((g) => Math.round(g * 10) / 10)), s = t.map((c) => c.place?.aim).filter((c) => !!c), i = (c, g) => {
    let d = je(e), v = {};
    for (let [y, E] of d) {
      let D = [0, 0, 0];
      D[c] = g(E[c]) - E[c], Object.assign(v, _e([y], D, d).lamps);
    }
    Ct(`Move ${Pn(e)}`, { lamps: v });
  }, p = (c, g) => Ye(e, c ? "tilt" : "pan", (d) => {
    if (!d.direction) return null;
    let v = no(d.direction, l);
    v[c] = g(v[c]);
    let y = Li(v[0], Math.max(-90, Math.min(90, v[1])), l), E = d.aim && d.position ? Mi(Za(d.aim, d.position)) : 0;
    return { direction: y, ...E && d.position ? { aim: Pt(d.position, qe(y, E)) } : {} };
  });
  return O(q, { title: "Place", note: "re-trace", children: [
    f(J, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => o(c, a)), set: i }),
    r.length > 0 && O(Vn, { children: [
      f(I, { label: "Pan", quantity: "angle", step: 1, value: K(u.map((c) => c[0])), set: (c) => p(0, c) }),
      f(I, { label: "Tilt", quantity: "angle", step: 1, value: K(u.map((c) => c[1])), set: (c) => p(1, c) }),
      f(
        J,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: s.length ? [0, 1, 2].map((c) => o(c, s)) : [NaN, NaN, NaN],
          set: (c, g) => Ye(e, "aim", (d) => {
            if (!d.direction || !d.position) return null;
            let v = ie(d.aim ?? Pt(d.position, qe(d.direction, 2)), c, g);
            return { aim: v, direction: oo(Za(v, d.position)) };
          })
        }
      )
    ] }),
    O("div", { class: "line", children: [
      f("span", { children: "Handles" }),
      O("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        f("button", { "aria-pressed": St.value === "move", onClick: () => St.value = "move", children: "Move" }),
        f("button", { "aria-pressed": St.value === "turn", onClick: () => St.value = "turn", children: "Turn" })
      ] })
    ] }),
    f("button", { class: "plain full", "aria-pressed": ro.value === "place", onClick: () => he("place"), children: "Put on a surface by pointing" }),
    r.length > 0 && vi.value && f("button", { class: "plain full", onClick: () => he("aim-here"), children: "Aim at the last point" })
  ] });
}
function Ai({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : O(q, { title: "Copies along a line", children: [
    f(I, { label: "How many", quantity: "number", step: 1, value: Ae.value, set: (n) => Ae.value = Math.max(1, Math.min(100, Math.round(n(Ae.value)))) }),
    f(J, { label: "Step", quantity: "length", step: 0.05, value: $t.value, set: (n, a) => $t.value = ie($t.value, n, a) }),
    O("button", { class: "plain full", onClick: () => pt(e, Ae.value, $t.value), children: [
      f(Re, { name: "copy" }),
      Ae.value === 1 ? "One copy" : `${Ae.value} copies`
    ] })
  ] });
}
function so() {
  let e = hi.value, t = e.map((l) => Ln.get(l)).filter((l) => !!l);
  if (!t.length) return f("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && Lt.get(n.group), o = Sn.value?.kind === "group" ? Lt.get(Sn.value.ids[0]) : void 0, r = n?.layer != null ? gi.value[n.layer] : void 0;
  return O(Vn, { children: [
    f("header", { class: "panel-head", children: n ? f(Te, { label: "Name of the lamp", value: n.name, set: (l) => Ct(`Rename ${n.name}`, { lamps: { [e[0]]: { name: l } } }) }) : o ? f(Te, { label: "Name of the group", value: o.name, set: (l) => Ct(`Rename ${o.name}`, { groups: { [Sn.value.ids[0]]: { name: l } } }) }) : O("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    f("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((l) => l.on).length} of ${t.length} on` }),
    O("div", { class: "scroll", children: [
      f(Pi, { ids: e, all: t }),
      f(Vi, { ids: e, all: t }),
      f(q, { title: "Photometry", children: f("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      f(Ei, { ids: e, all: t }),
      f(Ii, { ids: e, all: t }),
      f(Ai, { ids: e, all: t }),
      f("p", { class: "cost", children: t.every((l) => l.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as Tn,
  candles as Tt,
  command as Ri,
  digits as It,
  edit as uo,
  Field as qi,
  filterOf as ho,
  go as Fi,
  history as Hi,
  hovered as co,
  Icon as At,
  layers as Ni,
  lookOnly as po,
  maintenance as Fe,
  materials as Oi,
  percent as Di,
  scene as Wi,
  select as go,
  signal as Gi,
  singleKeys as mo,
  sub as Ki,
  things as Bi,
  travel as Et,
  Virtual as bo
} from "./desk.js";
import { Fragment as Ui, jsx as M, jsxs as T } from "./desk.js";
function fo() {
  let e = Wi.value;
  if (!e) return null;
  let t = Ki(e.bounds[1], e.bounds[0]);
  return T(Ui, { children: [
    T(q, { title: "Room", children: [
      T("p", { children: [
        t.map((n) => It(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${It(e.triangles)} triangles` : ""
      ] }),
      M("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && M("ul", { class: "buttons", children: e.cameras.map((n, a) => M("li", { children: M("button", { onClick: () => Fi(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && T("details", { children: [
        T("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        M("ul", { class: "remarks", children: e.warnings.map((n) => M("li", { children: n }, n)) })
      ] })
    ] }),
    T(q, { title: "Figures", children: [
      T("label", { class: "line", children: [
        M("span", { children: "Maintenance" }),
        M(qi, { label: "Maintenance factor", quantity: "share", value: Fe.value, step: 0.05, set: (n) => Fe.value = Math.max(0.1, Math.min(1, n(Fe.value))) })
      ] }),
      T("p", { class: "quiet", children: [
        Fe.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Fe.value === 1 && M("button", { class: "plain", onClick: () => Fe.value = 0.8, children: "0.80" })
      ] }),
      T("div", { class: "line", children: [
        M("span", { children: "Unit" }),
        T("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          M("button", { "aria-pressed": Tt.value === "lx", onClick: () => Tt.value = "lx", children: "lx, cd/m²" }),
          M("button", { "aria-pressed": Tt.value === "fc", onClick: () => Tt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    M(q, { title: "Layers of light", children: M("ul", { class: "layers", children: Ni.value.map((n, a) => T("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      M("i", { class: "dot", "aria-hidden": "true" }),
      M("span", { children: n.name || `layer ${a + 1}` }),
      M("small", { children: n.held ? "held" : Di(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    T(q, { title: "Hands", children: [
      T("div", { class: "line", children: [
        M("span", { children: "Faders" }),
        T("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          M("button", { "aria-pressed": Et.value === "square", onClick: () => Et.value = "square", children: "Square law" }),
          M("button", { "aria-pressed": Et.value === "linear", onClick: () => Et.value = "linear", children: "Even" })
        ] })
      ] }),
      T("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: mo.value, onChange: (n) => mo.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      T("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: po.value, onChange: (n) => po.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var Rt = Gi("");
function vo({ label: e }) {
  return M("span", { class: "field filter", children: M("input", { type: "text", "aria-label": e, placeholder: "Filter", value: Rt.value, onInput: (t) => Rt.value = t.currentTarget.value }) });
}
function yo() {
  let e = ho(Bi, Rt.value);
  return T("div", { class: "listing", children: [
    M(vo, { label: "Filter things" }),
    M(
      bo,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return T("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => co.value = { kind: "thing", id: n }, onPointerLeave: () => co.value = null, children: [
            M("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => uo(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: M(At, { name: a.hidden ? "eye-off" : "eye" }) }),
            M("button", { class: "row-name", onClick: () => go("thing", n), children: M("span", { children: a.name }) }),
            M("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => uo(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: M(At, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function ko() {
  let e = ho(Oi, Rt.value);
  return T("div", { class: "listing", children: [
    M(vo, { label: "Filter materials" }),
    M(
      bo,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return T("div", { class: "sheet-row material", role: "listitem", children: [
            M("button", { class: "row-name", onClick: () => go("material", n), children: M("span", { children: a.name }) }),
            T("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${It(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function wo() {
  let e = Hi.value;
  return T(q, { title: "History", children: [
    T("p", { children: [
      e.steps === 1 ? "One step" : `${It(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    T("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => Tn("undo"), children: [
      M(At, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    T("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => Tn("redo"), children: [
      M(At, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    M("button", { class: "plain full", onClick: () => Tn("save"), children: "Save a version with a name…" }),
    M("button", { class: "plain full", onClick: () => Ri({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as En,
  edit as $o,
  fromHex as _i,
  hex as ji,
  Icon as xo,
  materials as Co,
  middle as Mo,
  select as Lo,
  selection as Po,
  things as In
} from "./desk.js";
import { Fragment as Rn, jsx as L, jsxs as z } from "./desk.js";
var An = 180 / Math.PI;
function So(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * An : 0;
}
function zi(e, t) {
  let n = [0, 0, 0, Math.cos(t / An / 2)];
  return n[e] = Math.sin(t / An / 2), n;
}
function Vo() {
  let e = (Po.value?.ids ?? []).filter((s) => In.get(s)), t = e.map((s) => In.get(s));
  if (!t.length) return L("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((s) => s.locked), r = (s, i) => $o(`${a}: ${s}`, { things: Object.fromEntries(e.map((p, c) => [p, i(t[c])])) }), l = t.map((s) => s.place?.position ?? (s.box ? Mo(s.box) : [0, 0, 0])), u = n.box ? [0, 1, 2].map((s) => n.box[1][s] - n.box[0][s]) : null;
  return z(Rn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: a }) }),
    u && z("p", { class: "crumbs", children: [
      u.map((s) => En(s, 2)).join(" × "),
      " m"
    ] }),
    z("div", { class: "scroll", children: [
      z("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        z("button", { "aria-pressed": t.every((s) => s.hidden), onClick: () => r(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          L(xo, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        z("button", { "aria-pressed": o, onClick: () => r(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          L(xo, { name: o ? "lock" : "unlock" }),
          o ? "Locked" : "Lock"
        ] })
      ] }),
      z(q, { title: "Place", note: "re-trace", children: [
        o && L("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        L(
          J,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: o,
            value: [0, 1, 2].map((s) => K(l.map((i) => Math.round(i[s] * 1e4) / 1e4))),
            set: (s, i) => r("move", (p) => ({ place: { position: ie(p.place?.position ?? Mo(p.box), s, i) } }))
          }
        ),
        [0, 1, 2].map((s) => L(
          I,
          {
            label: `Turn ${"XYZ"[s]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: K(t.map((i) => Math.round(So(i.place?.rotation, s) * 10) / 10)),
            set: (i) => r("turn", (p) => ({ place: { rotation: zi(s, i(So(p.place?.rotation, s))) } }))
          },
          s
        )),
        L(
          I,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: o,
            value: K(t.map((s) => s.place?.scale ?? 1)),
            set: (s) => r("scale", (i) => ({ place: { scale: Math.max(1e-3, s(i.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      L(q, { title: "Materials", children: L("ul", { class: "buttons", children: n.materials.map((s) => L("li", { children: L("button", { onClick: () => Lo("material", s), children: Co.get(s)?.name ?? `material ${s}` }) }, s)) }) })
    ] })
  ] });
}
function To() {
  let e = Po.value?.ids[0], t = Co.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This material is gone." });
  let n = (i, p) => $o(`${t.name}: ${i}`, { materials: { [e]: p } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], l = ((i) => 0.2126 * i[0] + 0.7152 * i[1] + 0.0722 * i[2])(o), u = (i) => o.map((p) => Math.max(0, Math.min(1, l > 1e-4 ? p / l * i : i))), s = (i, p) => t[p] != null && z(Rn, { children: [
    z("div", { class: "line slide", children: [
      L("span", { children: i }),
      L(Ve, { label: i, name: `${t.name}: ${i.toLowerCase()}`, value: t[p], text: En(t[p], 2), patch: (c) => ({ materials: { [e]: { [p]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    L(I, { label: "", name: `${i}, typed`, quantity: "share", step: 0.01, value: t[p], set: (c) => n(i.toLowerCase(), { [p]: Math.max(0, Math.min(1, c(t[p]))) }) })
  ] });
  return z(Rn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: t.name }) }),
    L("p", { class: "crumbs", children: t.kind }),
    z("div", { class: "scroll", children: [
      z(q, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        z("div", { class: "line slide", children: [
          L("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          L(Ve, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: l, text: En(l, 2), patch: (i) => ({ materials: { [e]: { [a]: u(Math.min(0.95, i)) } } }) })
        ] }),
        L(I, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(l * 1e3) / 1e3, set: (i) => n("reflectance", { [a]: u(Math.min(0.98, i(l))) }) }),
        z("label", { class: "line", children: [
          L("span", { children: "Colour" }),
          L("input", { type: "color", class: "pick", "aria-label": "Colour", value: ji(o), onChange: (i) => n("colour", { [a]: _i(i.currentTarget.value) }) })
        ] }),
        s("Roughness", "roughness"),
        s("Gloss", "specular")
      ] }),
      L(q, { title: "On", children: L("ul", { class: "buttons", children: In.all().filter(([, i]) => i.materials.includes(e)).slice(0, 40).map(([i, p]) => L("li", { children: L("button", { onClick: () => Lo("thing", i), children: p.name }) }, i)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as Io, jsx as F, jsxs as qt } from "./desk.js";
var Ze = ["Scene", "Things", "Materials", "History"], ge = Yi("Scene");
function Zi() {
  let e = { Scene: fo, Things: yo, Materials: ko, History: wo }[ge.value];
  return qt(Io, { children: [
    F("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), ge.value = Ze[(Ze.indexOf(ge.value) + a + Ze.length) % Ze.length], document.getElementById(`tab-${ge.value}`)?.focus());
    }, children: Ze.map((n) => F("button", { id: `tab-${n}`, role: "tab", "aria-selected": ge.value === n, "aria-controls": "tab-panel", tabIndex: ge.value === n ? 0 : -1, onClick: () => ge.value = n, children: n }, n)) }),
    F("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${ge.value}`, tabIndex: 0, children: F(e, {}) })
  ] });
}
function Ji() {
  let e = Qi.value;
  return e ? qt(Io, { children: [
    qt("nav", { class: "chooser", "aria-label": "Selection", children: [
      F("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => Eo("previous"), children: F(qn, { name: "back" }) }),
      F("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => Eo("next"), children: F(qn, { name: "forth" }) }),
      F("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      F("span", { class: "gap" }),
      F("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: Xi, children: F(qn, { name: "close" }) })
    ] }),
    Fn.value && F("p", { class: "penless", children: Fn.value }),
    qt("fieldset", { class: "editing", disabled: Fn.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && F(so, {}),
      e.kind === "thing" && F(Vo, {}),
      e.kind === "material" && F(To, {}),
      e.kind === "meter" && F(Ua, {}),
      e.kind === "grid" && F(_a, {})
    ] })
  ] }) : F(Zi, {});
}

// src/later/legend.tsx
import { asked as es, candles as ts, display as ns, Field as as, show as os, three as ls, useRef as rs } from "./desk.js";
import { jsx as X, jsxs as Ft } from "./desk.js";
var Hn = [1, 2, 5];
function is(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, r = 10 ** Math.floor(Math.log10(o)), l = r * (Hn.find((u) => u * r >= o) ?? 10);
    for (let u = Math.ceil(e / l) * l; u <= t * 1.0001; u += l) a.push(u);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let r of Hn) {
      let l = r * 10 ** o;
      l >= e * 0.999 && l <= t * 1.001 && a.push(l);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function ss(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var se = (e, t) => {
  let n = es({ ...e, ...t });
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && os({ false_color: n });
};
function Ao(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return Hn[a] * 10 ** ((n - a) / 3);
}
function us() {
  let e = ns.value.false_color, t = rs(null);
  if (!e) return null;
  let n = ts.value === "fc", a = e.quantity === "illuminance", o = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", r = n ? a ? 1 / 10.7639 : 0.2919 : 1, l = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, u = e.ticks ?? is(e.low, e.high, e.scale).map((p) => [p, ss(p, e)]), s = (p) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: p, from: e[p] };
    },
    onPointerMove: (c) => {
      let g = t.current;
      g?.end === p && se(e, { [p]: Ao(g.from, Math.round((g.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let g = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      g && (c.preventDefault(), c.stopPropagation(), se(e, { [p]: Ao(e[p], g) }));
    }
  }), i = ({ end: p }) => Ft("div", { class: "end", children: [
    X(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": p === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[p],
        "aria-valuemin": 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${ls(e[p] * r)} ${o}`,
        ...s(p)
      }
    ),
    X(
      as,
      {
        label: p === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[p] * r).toPrecision(3)),
        set: (c) => se(e, { [p]: c(e[p] * r) / r })
      }
    )
  ] });
  return Ft("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    Ft("header", { children: [
      X(
        "button",
        {
          "aria-label": `${o}: ${a ? "illuminance" : "luminance"}, change`,
          onClick: () => se(e, { quantity: a ? "luminance" : "illuminance" }),
          children: o
        }
      ),
      X("button", { "aria-pressed": e.scale === "log", onClick: () => se(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      X("button", { "aria-pressed": e.lines, onClick: () => se(e, { lines: !e.lines }), children: "lines" })
    ] }),
    X(i, { end: "high" }),
    X("div", { class: "scale", style: { background: l }, children: u.map(([p, c]) => X("span", { style: { bottom: `${100 * c}%` }, children: String(Number((p * r).toPrecision(2))) }, p)) }),
    X(i, { end: "low" }),
    Ft("footer", { children: [
      X("button", { onClick: () => se(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      X("button", { onClick: () => se(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      X(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (p) => se(e, { palette: p.currentTarget.value }),
          children: e.palettes?.map((p) => X("option", { children: p }, p)) ?? X("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as Dn,
  act as Go,
  ask as ys,
  command as ks,
  copyText as ws,
  digits as xs,
  go as Ms,
  hear as Ss,
  lamps as $s,
  say as Dt,
  select as Cs,
  send as Nt,
  sheet as et,
  shown as Ls,
  signal as tt,
  useEffect as Wn,
  useLayoutEffect as Ps,
  useRef as Wt,
  walkNames as Vs,
  whyNotTo as Ts
} from "./desk.js";

// src/later/csv.ts
import { add as Ro, grids as cs, maintenance as ps, meters as ds, scale as qo, scene as Fo } from "./desk.js";
var ms = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function hs() {
  let e = ps.peek(), t = [["scene", Fo.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of ds.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of cs.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, r] of Object.entries(a)) t.push([o, r == null ? null : r * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, r) => {
      let [l, u] = [r % n.columns, Math.floor(r / n.columns)], s = Ro(n.corner, Ro(qo(n.u, (l + 0.5) / n.columns), qo(n.v, (u + 0.5) / n.rows)));
      t.push([...s.map((i) => i.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(ms).join(",")).join(`\r
`) + `\r
`;
}
function Nn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function Ho() {
  let e = URL.createObjectURL(new Blob([hs()], { type: "text/csv" }));
  Nn(`${Fo.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var Do = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], Ht = new Uint8Array(512), On = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  Ht[e] = Ht[e + 255] = t, On[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var No = (e, t) => e && t ? Ht[On[e] + On[t]] : 0;
function gs(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let r = new Array(n.length + 1).fill(0);
    n.forEach((l, u) => {
      r[u] ^= l, r[u + 1] ^= No(l, Ht[o]);
    }), n = r;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let r = a[o];
    r && n.forEach((l, u) => a[o + u] ^= No(l, r));
  }
  return a.slice(e.length);
}
function bs(e, t) {
  let [n, a, o] = Do[t - 1], r = [], l = (g, d) => {
    for (let v = d - 1; v >= 0; v--) r.push(g >> v & 1);
  };
  for (l(4, 4), l(e.length, 8), e.forEach((g) => l(g, 8)), l(0, Math.min(4, n * 8 - r.length)); r.length % 8; ) r.push(0);
  let u = [];
  for (let g = 0; g < r.length; g += 8) u.push(parseInt(r.slice(g, g + 8).join(""), 2));
  for (let g = 236; u.length < n; g ^= 253) u.push(g);
  let s = n / o, i = Array.from({ length: o }, (g, d) => u.slice(d * s, (d + 1) * s)), p = i.map((g) => gs(g, a)), c = (g) => g[0].flatMap((d, v) => g.map((y) => y[v]));
  return [...c(i), ...c(p)];
}
var fs = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function vs(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function Oo(e) {
  let t = e.length, n = 0, a = 0;
  for (let o of [!1, !0])
    for (let r = 0; r < t; r++) {
      let l = Array.from({ length: t }, (i, p) => o ? e[p][r] : e[r][p]), u = 1;
      for (let i = 1; i <= t; i++)
        i < t && l[i] === l[i - 1] ? u++ : (u >= 5 && (n += u - 2), u = 1);
      let s = l.map(Number).join("");
      for (let i = 0; i + 11 <= t; i++) {
        let p = s.slice(i, i + 11);
        (p === "10111010000" || p === "00001011101") && (n += 40);
      }
    }
  for (let o = 0; o < t; o++)
    for (let r = 0; r < t; r++)
      e[o][r] && a++, r && o && e[o][r] === e[o - 1][r] && e[o][r] === e[o][r - 1] && e[o][r] === e[o - 1][r - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function Wo(e) {
  let t = [...new TextEncoder().encode(e)], n = Do.findIndex(([d]) => t.length + 2 <= d) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), r = Array.from({ length: a }, () => new Array(a).fill(!1)), l = (d, v, y) => {
    d < 0 || v < 0 || d >= a || v >= a || (o[v][d] = y, r[v][d] = !0);
  };
  for (let d = 0; d < a; d++)
    l(d, 6, d % 2 === 0), l(6, d, d % 2 === 0);
  for (let [d, v] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let y = -4; y <= 4; y++)
      for (let E = -4; E <= 4; E++) {
        let D = Math.max(Math.abs(E), Math.abs(y));
        l(d + E, v + y, D !== 2 && D !== 4);
      }
  if (n > 1) {
    let d = a - 7;
    for (let v = -2; v <= 2; v++) for (let y = -2; y <= 2; y++) l(d + y, d + v, Math.max(Math.abs(y), Math.abs(v)) !== 1);
  }
  let u = (d) => {
    let v = vs(d);
    for (let y = 0; y < 15; y++) {
      let E = (v >> y & 1) === 1, D = y < 6 ? y : y < 8 ? y + 1 : a - 15 + y;
      l(8, D, E), l(y < 8 ? a - 1 - y : y < 9 ? 7 : 14 - y, 8, E);
    }
    l(8, a - 8, !0);
  };
  u(0);
  let s = bs(t, n), i = 0;
  for (let d = a - 1; d > 0; d -= 2) {
    d === 6 && (d = 5);
    for (let v = 0; v < a; v++)
      for (let y of [d, d - 1]) {
        let D = (d + 1 & 2) === 0 ? a - 1 - v : v;
        r[D][y] || (o[D][y] = i < s.length * 8 && (s[i >> 3] >> 7 - (i & 7) & 1) === 1, i++);
      }
  }
  let p = (d) => (u(d), o.map((v, y) => v.map((E, D) => E !== (!r[y][D] && fs[d](D, y))))), c = p(0), g = Oo(c);
  for (let d = 1; d < 8; d++) {
    let v = p(d), y = Oo(v);
    y < g && ([c, g] = [v, y]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as Ds, jsx as h, jsxs as P } from "./desk.js";
function nt({ title: e, wide: t, children: n }) {
  let a = Wt(null);
  Ps(() => {
    let r = a.current, l = document.activeElement;
    return r.open || r.showModal(), () => l?.focus();
  }, []);
  let o = () => et.value = null;
  return h(
    "dialog",
    {
      ref: a,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: o,
      onClick: (r) => r.target === a.current && o(),
      children: P("div", { class: "sheet-body", children: [
        P("header", { children: [
          h("h2", { children: e }),
          h("span", { class: "gap" }),
          h("button", { onClick: o, children: "Close" })
        ] }),
        n
      ] })
    }
  );
}
var Es = [
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
function Is() {
  let e = [...new Set(Dn().map((t) => t.group))];
  return h(nt, { title: "All keys", wide: !0, children: P("div", { class: "help", children: [
    P("table", { children: [
      h("caption", { class: "spoken", children: "By hand" }),
      h("thead", { children: P("tr", { children: [
        h("th", { scope: "col", children: "What" }),
        h("th", { scope: "col", children: "Mouse" }),
        h("th", { scope: "col", children: "Keys, in the view" }),
        h("th", { scope: "col", children: "Fingers" })
      ] }) }),
      h("tbody", { children: Es.map(([t, n, a, o]) => P("tr", { children: [
        h("th", { scope: "row", children: t }),
        h("td", { children: n }),
        h("td", { children: a.replace("walking keys", Vs.value) }),
        h("td", { children: o })
      ] }, t)) })
    ] }),
    P("div", { class: "columns", children: [
      e.map((t) => P("section", { children: [
        h("h3", { children: t }),
        h("dl", { children: Dn().filter((n) => n.group === t && n.keys).map((n) => P(Ds, { children: [
          h("dt", { children: n.label }),
          h("dd", { children: h("kbd", { children: n.keys }) })
        ] })) })
      ] }, t)),
      P("section", { children: [
        h("h3", { children: "Numbers" }),
        P("dl", { children: [
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
var Ot = tt(""), Je = tt(0);
function As() {
  let e = Ot.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = Dn().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: Ts(a.id), run: () => Go(a.id) }));
  for (let { name: a, camera: o } of ht())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => Ms(o, a) });
  if (e.length)
    for (let [a, o] of $s.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => Cs("lamp", a) });
    }
  return n.slice(0, 60);
}
function Rs() {
  let e = As(), t = Math.min(Je.value, e.length - 1);
  Wn(() => {
    Ot.value = "", Je.value = 0;
  }, []), Wn(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (et.value = null, a.why ? Dt(a.why, "warn") : setTimeout(a.run, 0));
  };
  return P(nt, { title: "Command palette", children: [
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
        value: Ot.value,
        onInput: (a) => {
          Ot.value = a.currentTarget.value, Je.value = 0;
        },
        onKeyDown: (a) => {
          let o = { ArrowDown: 1, ArrowUp: -1 }[a.key];
          o && (a.preventDefault(), Je.value = (t + o + e.length) % Math.max(1, e.length)), a.key === "Enter" && (a.preventDefault(), n(e[t]));
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
          onPointerMove: () => Je.value = o,
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
var Ko = tt([]);
Ss("links", (e) => Ko.value = e.links);
function qs({ text: e }) {
  let t = Wo(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, r) => o.map((l, u) => l ? `M${u + 4} ${r + 4}h1v1h-1z` : "").join("")).join("");
  return P("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    h("rect", { width: n, height: n, fill: "#fff" }),
    h("path", { d: a, fill: "#000" })
  ] });
}
function Fs() {
  let e = tt(null), t = Wt(e).current;
  return Wn(() => {
    Nt({ do: "links", what: "list" });
  }, []), P(nt, { title: "Share by link", children: [
    h("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    h("ul", { class: "links", children: Ko.value.map((n) => P("li", { children: [
      h("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      h("code", { children: n.address }),
      P("span", { class: "buttons", children: [
        h("button", { onClick: () => {
          ws(n.address);
        }, children: "Copy" }),
        h("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        h("button", { onClick: () => Nt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && h(qs, { text: n.address })
    ] }, n.id)) }),
    P("footer", { children: [
      h("button", { onClick: () => Nt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      h("button", { onClick: () => Nt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function Hs() {
  let e = Wt(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    ks({ do: "save", name: n }), et.value = null, Dt(`Saving the version “${n}”.`);
  };
  return P(nt, { title: "Save a version", children: [
    h("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    P("label", { class: "line", children: [
      h("span", { children: "Name" }),
      h("span", { class: "field", children: h("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    h("footer", { children: h("button", { onClick: t, children: "Save" }) })
  ] });
}
var ee = tt(null);
function Ns() {
  let e = Ls.value?.head, t = Wt(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    ee.value = 0;
    let [o, r] = [Number(n("width")), Number(n("height"))];
    ys("picture", { format: n("format"), width: o, height: r, batches: Number(n("batches")) }, (l) => {
      l.why ? (ee.value = null, Dt(l.why, "warn")) : l.url ? (ee.value = null, Nn(l.name, l.url), et.value = null) : ee.value = l.progress ?? 0;
    }, (l) => {
      ee.value = null, Dt(l, "warn");
    });
  };
  return P(nt, { title: "Save the picture", children: [
    P("div", { ref: t, class: "form", children: [
      P("label", { class: "line", children: [
        h("span", { children: "Format" }),
        P("select", { name: "format", children: [
          h("option", { value: "png", children: "PNG, as it is shown" }),
          h("option", { value: "exr", children: "EXR, the light itself" })
        ] })
      ] }),
      P("label", { class: "line", children: [
        h("span", { children: "Width" }),
        h("input", { type: "number", name: "width", min: 16, max: 16384, value: Math.max(e?.width ?? 0, 640) })
      ] }),
      P("label", { class: "line", children: [
        h("span", { children: "Height" }),
        h("input", { type: "number", name: "height", min: 16, max: 16384, value: Math.max(e?.height ?? 0, 480) })
      ] }),
      P("label", { class: "line", children: [
        h("span", { children: "Batches" }),
        h("input", { type: "number", name: "batches", min: 1, max: 1e5, value: 64 })
      ] })
    ] }),
    ee.value !== null && h("progress", { max: 1, value: ee.value, "aria-label": "Rendering" }),
    P("footer", { children: [
      h("button", { onClick: () => Go("command"), children: "Copy the command" }),
      h("button", { disabled: ee.value !== null, onClick: a, children: ee.value === null ? "Render and save" : ee.value ? `${xs(ee.value * 100)} %` : "Rendering…" })
    ] })
  ] });
}
function Os() {
  switch (et.value) {
    case "help":
      return h(Is, {});
    case "palette":
      return h(Rs, {});
    case "share":
      return h(Fs, {});
    case "save":
      return h(Hs, {});
    case "picture":
      return h(Ns, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import {
  act as Ws,
  colorText as Bo,
  cost as Gs,
  css as Ks,
  Field as Bs,
  groups as Us,
  hovered as Gt,
  Icon as _s,
  lamps as js,
  lumensOf as zs,
  penless as Xs,
  pickRow as Qs,
  select as Ys,
  selection as Uo,
  switchOn as Zs,
  three as Js,
  typeGroupLevel as eu,
  typeLevel as tu
} from "./desk.js";
import { jsx as Y, jsxs as Gn } from "./desk.js";
function nu() {
  return Gn("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    Y("span", {}),
    Y("span", { children: "Name" }),
    Y("span", { children: "Level" }),
    Y("span", { children: "lm" }),
    Y("span", { children: "White" })
  ] });
}
function au({ row: e, index: t, count: n }) {
  let a = e.kind === "lamp" ? js.get(e.id) : void 0, o = e.kind === "group" ? Us.get(e.id) : void 0, r = a ?? o;
  if (!r) return null;
  let l = Uo.value?.kind === e.kind && Uo.value.ids.includes(e.id), u = zs(o?.lamps ?? [e.id]), s = Xs.value, i = Gt.value?.kind === e.kind && Gt.value.id === e.id;
  return Gn(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${l ? "selected" : ""} ${r.on ? "" : "off"} ${i ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => Gt.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => Gt.value = null,
      children: [
        Y("button", { class: "icon power", "aria-pressed": r.on, disabled: s !== null, title: s ?? void 0, "aria-label": `${r.name} on`, onClick: () => Zs(e, !r.on), children: Y(_s, { name: "power" }) }),
        Y("button", { class: "row-name", "aria-pressed": l, title: a ? Gs(a) : void 0, onClick: (p) => Qs(p, e.kind, e.id), onDblClick: () => Ws("frame"), children: Y("span", { children: r.name }) }),
        Y(
          Bs,
          {
            label: `${r.name} level`,
            quantity: "level",
            value: r.level,
            flux: a?.flux,
            step: 0.01,
            disabled: s !== null,
            why: s,
            set: (p) => a ? tu([e.id], p) : eu(e.id, p)
          }
        ),
        Y("span", { class: "lumens", children: Js(u) }),
        a ? Gn("button", { class: "tint", "aria-label": `${r.name} colour: ${Bo(a)}`, onClick: () => Ys("lamp", e.id), children: [
          Y("i", { class: "swatch", style: { background: Ks(a.swatch) } }),
          Bo(a)
        ] }) : Y("span", {})
      ]
    }
  );
}

// src/later/strip.tsx
import {
  act as Kn,
  command as Qo,
  digits as Bn,
  fade as Kt,
  Field as ou,
  grids as _o,
  Icon as He,
  looks as jo,
  luxText as be,
  maintenance as lu,
  meters as zo,
  select as Xo,
  selection as Bt,
  signal as ru,
  storeLook as iu
} from "./desk.js";
import { Fragment as du, jsx as x, jsxs as H } from "./desk.js";
var Un = ru("looks");
function su() {
  return H("section", { class: "looks", "aria-label": "Looks", children: [
    H("header", { children: [
      x("h2", { children: "Looks" }),
      x("button", { class: "tab", onClick: () => Un.value = "meters", children: "Meters" }),
      x("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: iu, children: x(He, { name: "plus" }) }),
      x("span", { class: "gap" }),
      H("label", { class: "tint", children: [
        "Fade",
        x(ou, { label: "Cross-fade", quantity: "seconds", value: Kt.value, step: 0.5, set: (e) => Kt.value = Math.max(0, e(Kt.value)) })
      ] })
    ] }),
    H("ul", { children: [
      jo.all().map(([e, t], n) => H("li", { class: "look", children: [
        H("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Qo({ do: "look", id: e, what: "recall", seconds: Kt.peek() }), children: [
          t.picture && x("img", { src: t.picture, alt: "" }),
          x("span", { children: t.name })
        ] }),
        x(uu, { id: e, name: t.name })
      ] }, e)),
      !jo.ids.value.length && x("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function uu({ id: e, name: t }) {
  let n = `look-${e}`, a = (u) => {
    let s = u.getBoundingClientRect(), i = document.getElementById(n);
    i?.style.setProperty("left", `${Math.min(s.left, innerWidth - 296)}px`), i?.style.setProperty("bottom", `${innerHeight - s.top + 4}px`), i?.style.setProperty("top", "auto");
  }, o = { popovertarget: n }, r = () => document.getElementById(n)?.hidePopover(), l = (u, s = {}) => {
    r(), Qo({ do: "look", id: e, what: u, ...s });
  };
  return H(du, { children: [
    x("button", { class: "icon more", ...o, "aria-label": `More of ${t}`, onPointerDown: (u) => a(u.currentTarget), onFocus: (u) => a(u.currentTarget), children: x(He, { name: "more" }) }),
    H("div", { id: n, popover: "auto", class: "menu", children: [
      H("label", { class: "line", children: [
        x("span", { children: "Name" }),
        x("span", { class: "field", children: x("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (u) => l("rename", { name: u.currentTarget.value }) }) })
      ] }),
      x("button", { class: "item", onClick: () => l("update"), children: x("span", { children: "Update to what is set now" }) }),
      x("button", { class: "item", onClick: () => l("recall", { seconds: 0 }), children: x("span", { children: "Recall at once" }) }),
      x("button", { class: "item", onClick: () => l("remove"), children: x("span", { children: "Remove" }) })
    ] })
  ] });
}
function cu() {
  let e = lu.value;
  return H("section", { class: "readings", "aria-label": "Meters and grids", children: [
    H("header", { children: [
      x("h2", { children: "Meters" }),
      x("button", { class: "tab", onClick: () => Un.value = "looks", children: "Looks" }),
      x("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => Kn("meter-tool"), children: x(He, { name: "meter" }) }),
      x("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => Kn("grid"), children: x(He, { name: "grid" }) }),
      x("button", { onClick: () => Kn("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      x("button", { onClick: Ho, title: "Save all figures as CSV", children: "CSV" }),
      x("span", { class: "gap" }),
      x("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${Bn(e, 2)} maintained` })
    ] }),
    H("ul", { children: [
      zo.all().map(([t, n]) => {
        let a = n.lux;
        return x("li", { children: H("button", { class: "reading", "aria-pressed": Bt.value?.kind === "meter" && Bt.value.ids.includes(t), onClick: () => Xo("meter", t), children: [
          H("span", { class: "tint", children: [
            x(He, { name: "meter" }),
            n.name,
            " ",
            x(gn, { of: kt(n) })
          ] }),
          x("strong", { class: vt(n) ? "unsettled" : "", children: a ? be(a[0] * e) : "…" }),
          H("small", { children: [
            a?.[1] != null ? `±${be(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind,
            n.target ? ` · wants ${be(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      _o.all().map(([t, n]) => {
        let a = n.target;
        return x("li", { children: H("button", { class: "reading", "aria-pressed": Bt.value?.kind === "grid" && Bt.value.ids.includes(t), onClick: () => Xo("grid", t), children: [
          H("span", { class: "tint", children: [
            x(He, { name: "grid" }),
            n.name,
            " ",
            x(gn, { of: wt(n) })
          ] }),
          x("strong", { class: yt(n) ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${be(n.mean * e)}${n.error == null ? "" : ` ±${be(n.error * e, !1)}`}` }),
          H("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : Bn(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : be(n.min * e, !1),
            " to",
            " ",
            n.max == null ? "…" : be(n.max * e, !1),
            a ? ` · wants ${be(a.lux)}, U₀ ${Bn(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !zo.ids.value.length && !_o.ids.value.length && x("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function pu() {
  return H("div", { class: "strip-parts", "data-tab": Un.value, children: [
    x(su, {}),
    x(cu, {})
  ] });
}

// src/later/menus.tsx
import {
  camera as Jo,
  digits as el,
  display as mu,
  Field as _t,
  go as tl,
  houseLights as _n,
  Item as Se,
  Range as hu,
  show as jn,
  theme as Yo,
  walking as gu
} from "./desk.js";
import { Fragment as jt, jsx as S, jsxs as te } from "./desk.js";
var Ut = Math.PI / 360;
function Zo(e) {
  let t = Jo.peek();
  t && tl({ ...t, fov: Math.max(3, Math.min(140, e)) });
}
function bu() {
  let e = Jo.value, t = ht();
  return te(jt, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((n) => S(Se, { id: n }, n)),
    S("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((n) => S(Se, { id: `preset-${n}` }, n)),
    S("hr", {}),
    t.length > 0 && S("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    t.map(({ name: n, camera: a }, o) => S("button", { class: "item", onClick: () => tl(a, n), children: S("span", { children: n }) }, o)),
    t.length > 0 && S("hr", {}),
    e && !e.height && te(jt, { children: [
      te("label", { class: "line", children: [
        S("span", { children: "Angle" }),
        S(_t, { label: "Vertical angle of view", quantity: "angle", value: e.fov, step: 1, set: (n) => Zo(n(e.fov)) })
      ] }),
      te("label", { class: "line", children: [
        S("span", { children: "Focal length" }),
        S(_t, { label: "Focal length on 36 × 24 mm", quantity: "number", value: Math.round(120 / Math.tan(e.fov * Ut)) / 10, text: `${el(12 / Math.tan(e.fov * Ut), 1)} mm`, step: 1, set: (n) => Zo(Math.atan(12 / Math.max(2, n(12 / Math.tan(e.fov * Ut)))) / Ut) })
      ] }),
      S("hr", {})
    ] }),
    S(Se, { id: "walking", label: gu.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    S(Se, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((n) => S(Se, { id: `hands-${n}` }, n))
  ] });
}
var fu = ["linear", "reinhard", "filmic"];
function vu() {
  let e = mu.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return te(jt, { children: [
    te("fieldset", { children: [
      S("legend", { children: "Tone curve" }),
      S("div", { class: "segments", children: fu.map((n) => S("button", { "aria-pressed": e.tone === n, onClick: () => jn({ tone: n }), children: n }, n)) })
    ] }),
    te("fieldset", { children: [
      S("legend", { children: "White balance" }),
      te("label", { class: "line", children: [
        S("span", { children: "White" }),
        S(_t, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => jn({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      te("label", { class: "line", children: [
        S("span", { children: "Tint" }),
        S(_t, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => jn({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    S("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => S(Se, { id: n }, n))
  ] });
}
function yu() {
  return te(jt, { children: [
    te("label", { class: "line", children: [
      S("span", { children: "House lights" }),
      S(hu, { label: "House lights", value: _n.value, text: `${el(_n.value * 100)} %`, on: (e) => _n.value = Math.max(0.3, e) })
    ] }),
    S("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => S("button", { "aria-pressed": Yo.value === e, onClick: () => Yo.value = e, children: e }, e)) }),
    S("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => S(Se, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as zt, cut as ku, digits as nl, edit as al, go as wu, Icon as at, Range as xu, setCut as Mu, signal as Su, storeView as $u, viewName as Cu, views as Lu } from "./desk.js";
import { jsx as G, jsxs as zn } from "./desk.js";
var Xt = Su(null);
function Pu() {
  let e = Lu.all();
  return zn("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    G("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => zt("home"), children: G(at, { name: "home" }) }),
    G("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => zt("frame"), children: G(at, { name: "frame" }) }),
    G("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => zt("back"), children: G(at, { name: "back" }) }),
    G("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => zt("forth"), children: G(at, { name: "forth" }) }),
    G("span", { class: "divide" }),
    e.map(([t, n], a) => Xt.value === t ? G("span", { class: "field", children: G(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (o) => o?.focus(),
        onBlur: (o) => {
          let r = o.currentTarget.value.trim();
          Xt.value = null, r && r !== n.name && al(`Rename the view ${r}`, { views: { [t]: { ...n, name: r } } });
        },
        onKeyDown: (o) => {
          o.stopPropagation(), o.key === "Escape" && (o.currentTarget.value = n.name ?? ""), (o.key === "Enter" || o.key === "Escape") && o.currentTarget.blur();
        }
      }
    ) }, t) : zn(
      "button",
      {
        class: "saved-view",
        "aria-pressed": Cu.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click or F2 renames, Delete removes`,
        onClick: () => wu(n, n.name ?? "view"),
        onDblClick: () => Xt.value = t,
        onKeyDown: (o) => {
          o.key === "F2" && (Xt.value = t), o.key === "Delete" && (o.stopPropagation(), al(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          G("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    G("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: $u, children: G(at, { name: "plus" }) })
  ] });
}
function Vu() {
  let e = ku.value;
  if (!e) return null;
  let t = e.height === null ? `${nl(e.value, 2)} m` : `at ${nl(e.height, 2)} m`;
  return zn("label", { class: "cut", "data-scroll": !0, children: [
    G("span", { children: "Cut" }),
    G(
      xu,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => Mu(n * e.most)
      }
    ),
    G("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as Tu, useRef as Eu } from "./desk.js";
import { jsx as ol } from "./desk.js";
function Iu() {
  let e = Eu(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let r = a.getBoundingClientRect(), l = (i) => Math.max(-1, Math.min(1, i)), u = o ? 0 : l((n.clientX - r.left) / (r.width / 2) - 1), s = o ? 0 : l(1 - (n.clientY - r.top) / (r.height / 2));
    e.current?.style.setProperty("transform", `translate(${u * 28}px, ${-s * 28}px)`), Tu(s, u);
  };
  return ol("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: ol("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as ll,
  closeWhat as rl,
  digits as Au,
  hovered as il,
  Icon as Ru,
  lamps as qu,
  luxText as fe,
  nameOf as Fu,
  select as Hu,
  useEffect as Nu,
  useRef as Ou,
  viewSize as Du,
  what as Wu
} from "./desk.js";
import { jsx as B, jsxs as ne } from "./desk.js";
var $e = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], Gu = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function Ku() {
  let e = Wu.value, t = Ou(null);
  if (Nu(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = Du.value, o = [...e.lamps].sort((c, g) => $e(g) - $e(c)), r = o.reduce((c, g) => c + $e(g), 0) || 1, l = o.slice(0, 9), u = r - l.reduce((c, g) => c + $e(g), 0), s = Math.max(8, Math.min(e.x + 12, n - 332)), i = Math.max(8, Math.min(e.y + 12, a - 150 - 35 * l.length)), p = e.lux ? `${fe(e.lux[0])} ±${fe(e.lux[1], !1)}` : "Measuring…";
  return ne(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${s}px`, top: `${i}px` },
      onKeyDown: (c) => {
        c.key === "Escape" && (c.stopPropagation(), rl(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        ne("header", { children: [
          B("strong", { class: e.done ? "" : "unsettled", children: p }),
          B("span", { class: "quiet", children: "what lights this" }),
          B("button", { class: "icon", "aria-label": "Close", onClick: rl, children: B(Ru, { name: "close" }) })
        ] }),
        ne("ol", { children: [
          l.map((c) => B(
            "li",
            {
              onPointerEnter: () => il.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => il.value = null,
              children: ne("button", { class: "row", onClick: () => Hu("lamp", c.id), children: [
                B("span", { class: "name", children: Fu("lamp", c.id) }),
                ne("span", { class: "figure", children: [
                  Au(100 * $e(c) / r, $e(c) / r < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                ne("span", { class: "figure lux", children: [
                  fe($e(c)),
                  " ±",
                  fe(Gu(c), !1)
                ] }),
                ne("span", { class: "shares", "aria-hidden": "true", children: [
                  B("i", { class: "direct", style: { width: `${100 * c.direct[0] / r}%` } }),
                  B("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / r}%` } }),
                  B("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / r}%` } })
                ] }),
                ne("span", { class: "spoken", children: [
                  "direct ",
                  fe(c.direct[0]),
                  ", indirect ",
                  fe(c.indirect[0]),
                  ", caustic",
                  " ",
                  fe(c.caustic[0])
                ] })
              ] })
            },
            c.id
          )),
          o.length > l.length && ne("li", { class: "quiet", children: [
            o.length - l.length === 1 ? "one more" : `${o.length - l.length} more together`,
            ": ",
            fe(u)
          ] }),
          !o.length && B("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        ne("footer", { children: [
          B("span", { class: "key direct", children: "direct" }),
          B("span", { class: "key indirect", children: "indirect" }),
          B("span", { class: "key caustic", children: "caustic" }),
          B("span", { class: "gap" }),
          ll.value.some((c) => qu.get(c)?.place?.direction) && B("button", { onClick: () => Be(ll.peek(), e.hit.point), children: "Aim here" }),
          B("button", { onClick: () => Ue(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  sr as Compare,
  Vu as CutBar,
  Br as Gizmo,
  Ji as Inspector,
  us as Legend,
  yu as PageItems,
  vu as SeeingItems,
  nu as SheetHead,
  au as SheetRow,
  Os as Sheets,
  pu as Strip,
  bu as ViewItems,
  Pu as ViewStrip,
  Iu as WalkPad,
  Ku as What
};
