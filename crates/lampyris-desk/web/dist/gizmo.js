// src/later/actions.ts
import {
  adding as Kl,
  asked as Bl,
  ask as Ul,
  back as _l,
  candles as ba,
  chosenLamps as pe,
  clearSolo as jl,
  command as cn,
  compareHeld as zl,
  copyText as Xl,
  deselect as Ql,
  each as dn,
  edit as mn,
  exposeBy as fa,
  falseColor as Yl,
  fine as va,
  forth as Zl,
  frameSelection as Jl,
  go as er,
  goHome as tr,
  goInside as nr,
  goPreset as ar,
  handles as ya,
  hands as or,
  here as lr,
  highlight as rr,
  history as ka,
  lampMarks as wa,
  lamps as bt,
  listing as xa,
  lookOnly as Ma,
  panels as Sa,
  PRESETS as ir,
  register as sr,
  say as gt,
  scene as ur,
  selection as Ta,
  send as cr,
  sheet as ze,
  show as pr,
  soloSelection as dr,
  spot as Xe,
  startTool as xe,
  stepSelection as Ca,
  storeLook as mr,
  storeView as hr,
  theme as $a,
  things as La,
  titleOf as Ea,
  toggleFalse as gr,
  toggleWipe as br,
  travel as Pa,
  views as fr,
  walking as pn,
  whyNot as Q
} from "./desk.js";

// src/later/tools.ts
import {
  add as ct,
  adding as Vl,
  chosenLamps as sa,
  distance as Tl,
  dot as El,
  edit as pt,
  effect as Il,
  free as da,
  grids as ua,
  lamps as Ve,
  meters as ca,
  normal as ma,
  onTool as Al,
  positionOf as Rl,
  say as dt,
  scale as ut,
  select as ql,
  step as rn,
  sub as sn,
  titleOf as mt,
  tool as we,
  untracked as Fl,
  up as ha,
  workPlane as Hl
} from "./desk.js";

// src/later/area.ts
import { ask as vl, camera as yl, cross as kl, dot as ke, effect as oa, add as an, normal as wl, scale as Pe, scene as la, selection as xl, signal as Ml, sub as Sl, tool as Cl } from "./desk.js";
var $l = 0.5, Ll = 0.3;
function Pl(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
var it = (e, t = 0) => e > 2 * t ? e - 2 * t : e;
function ln(e) {
  let [t, n] = [Math.min(...e), Math.max(...e)], a = n >= 2 * t ? t : n, o = a / Math.max(1, Math.round(a / Pl(a)));
  return e.map((r) => Math.max(1, Math.round(r / o)));
}
function ra(e, t, n, a, o) {
  let r = Math.abs(n[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], l = wl(kl(n, r)), c = Sl(t.point, e.point), [p, i] = [ke(c, r), ke(c, l)];
  if (Math.abs(p) < 0.05 || Math.abs(i) < 0.05) return null;
  let s = (ee) => ke(ee, n) - a, u = [e, t].every((ee) => ke(ee.normal, n) > 0.7 && s(ee.point) > Ll), h = u ? 0 : $l, d = u ? 0 : o - s(e.point), v = an(an(e.point, Pe(n, d)), an(Pe(r, Math.min(p, 0)), Pe(l, Math.min(i, 0)))), f = [Math.abs(p), Math.abs(i)], [T, F] = ln(f.map((ee) => it(ee, h)));
  return { corner: v, u: Pe(r, f[0]), v: Pe(l, f[1]), normal: n, columns: T, rows: F, border: h };
}
var ia = Ml(null);
function st() {
  let e = la.value;
  return ia.value ?? (e ? Math.min(ke(e.bounds[0], e.up), ke(e.bounds[1], e.up)) : 0);
}
var on = null;
oa(() => {
  let e = yl.value;
  e && !e.height && (on = e.eye);
});
oa(() => {
  let e = la.value?.up;
  !e || !on || Cl.value !== "grid" && xl.value?.kind !== "grid" || vl("ray", { origin: on, direction: Pe(e, -1) }, (t) => {
    t.hit && (ia.value = ke(t.point, e));
  });
});

// src/later/tools.ts
var Ke = null, Nl = { lux: 500, uniformity: 0.6 };
Il(() => {
  we.value !== "grid" && (Ke = null);
});
function Ol(e) {
  if (!e) return dt("There is nothing at that point.", "warn");
  switch (we.peek()) {
    case "aim":
      Be(sa.peek(), e.point), we.value = null;
      break;
    case "place":
      Dl(sa.peek(), e), we.value = null;
      break;
    case "meter":
      Ue(e.point, e.normal), we.value = null;
      break;
    case "grid":
      if (!Ke) {
        Ke = e;
        return;
      }
      Wl(Ke, e), Ke = null, we.value = null;
      break;
    case "add":
      Gl(Vl.peek(), e), we.value = null;
      break;
  }
}
Al(Ol);
function Be(e, t) {
  let n = {};
  for (let a of e) {
    let o = Ve.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: ma(sn(t, o.position)) } });
  }
  if (!Object.keys(n).length) return dt("What is selected shines into all directions: it cannot be aimed.", "warn");
  pt(`Aim ${mt(e)}`, { lamps: n });
}
function un(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let r = o.filter((l) => !n.has(l));
    r.length && (ql(t, r[r.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), 3e3);
}
function Dl(e, t) {
  let n = je(e), a = n.get(e[e.length - 1]);
  if (!a) return dt("What is selected has no place.", "warn");
  let o = (Ve.get(e[e.length - 1])?.place?.radius ?? 0) + 0.02;
  pt(`Put ${mt(e)} on a surface`, _e(e, sn(ct(t.point, ut(t.normal, o)), a), n));
}
function Ue(e, t) {
  let n = da(ca);
  un(ca, "meter"), pt("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function Wl(e, t) {
  let n = ra(e, t, ha.peek(), Fl(st), Hl.peek());
  if (!n) return dt("An area needs two corners that lie apart.", "warn");
  let a = da(ua);
  un(ua, "grid"), pt("Lay a grid", { grids: { [a]: { name: `Area ${a + 1}`, ...n, target: Nl } } });
}
var pa = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function Gl(e, t) {
  let n = ha.peek(), a = El(t.normal, n), o = a > 0.7 ? ct(t.point, ut(n, 1.2)) : ct(t.point, ut(t.normal, 0.15)), r = a > 0.7 || a < -0.7 ? ut(n, -1) : t.normal, l = { position: o };
  e !== "point" && e !== "sphere" && (l.direction = r), e === "spot" && Object.assign(l, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (l.radius = 0.15), e === "sphere" && (l.radius = 0.08);
  let c = Ve.all().filter(([, p]) => p.own).length;
  un(Ve, "lamp"), rn(`Add ${pa[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${pa[e] ?? e} ${c + 1}`, kind: e, flux: 800, place: l }
  });
}
function ht(e, t, n) {
  !e.length || t < 1 || rn(`Copy ${mt(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function ga(e) {
  e.length && rn(`Remove ${mt(e)}`, { do: "remove", lamps: e });
}
function _e(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = Ve.get(o)?.place, l = n.get(o);
    if (!l) continue;
    let c = ct(l, t), p = r?.aim && Tl(r.aim, c) > 1e-6 ? { direction: ma(sn(r.aim, c)) } : {};
    a[o] = { place: { position: c, ...p } };
  }
  return { lamps: a };
}
function je(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = Ve.get(n), o = a && Rl(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/actions.ts
var oe = () => Q() ?? (pe.value.length ? null : "Select a lamp first.");
function vr() {
  let e = pe.peek(), t = !e.some((n) => bt.get(n)?.on);
  mn(`${Ea(e)} ${t ? "on" : "off"}`, { lamps: dn(e, { on: t }) });
}
function yr() {
  let e = pe.peek(), t = !e.every((n) => bt.get(n)?.parked);
  mn(`${t ? "Park" : "Unpark"} ${Ea(e)}`, { lamps: dn(e, { parked: t }) });
}
function Va(e) {
  let t = Ta.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : La.ids.peek().filter((a) => La.get(a)?.hidden);
  if (!n.length) return gt(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  mn(e ? "Hide things" : "Show hidden things", { things: dn(n, { hidden: e }) });
}
function kr() {
  let e = pe.peek()[0], t = bt.get(e)?.place, n = lr();
  if (!t?.position || !t.direction || !n) return gt("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  er({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function wr() {
  Ul("command", {}, (e) => {
    Xl(e.text);
  });
}
var xr = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Mr = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, Sr = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: Jl },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: tr },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: nr },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: _l },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: Zl },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: hr, why: Q },
  ...ir.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Mr[e],
    keys: `Shift+${t + 1}`,
    run: () => ar(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      pn.value = pn.peek() === "walk" ? "fly" : "walk", gt(pn.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: kr, why: oe },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => Ca(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => Ca(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => xe("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => Ta.value = { kind: "lamp", ids: bt.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: Ql },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: vr, why: oe },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: dr, why: () => pe.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: jl },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => rr(!0), why: oe },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: yr, why: oe },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => xe("aim"), why: oe },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => Xe.peek() && Be(pe.peek(), Xe.peek().point), why: oe },
  { id: "place", group: "Lamps", label: "Put on a surface by pointing", keys: "Shift+N", run: () => xe("place"), why: oe },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => ya.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => ya.value = "turn" },
  ...xr.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: Q,
    run: () => {
      Kl.value = e, xe("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => ht(pe.peek(), 1, [0.5, 0, 0]), why: oe },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => ga(pe.peek()), why: oe },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => Va(!0), why: Q },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => Va(!1), why: Q },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => cn({ do: "undo" }), why: () => Q() ?? (ka.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => cn({ do: "redo" }), why: () => Q() ?? (ka.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => ze.value = "save", why: Q },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => ze.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: wr },
  { id: "share", group: "Work", label: "Share by link", run: () => ze.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: gr },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = Yl();
      pr({ false_color: { ...Bl(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => fa(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => fa(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => cr({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => zl(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: br },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: Q, run: () => Xe.peek() ? Ue(Xe.peek().point, Xe.peek().normal) : xe("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => xe("meter"), why: Q },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => xe("grid"), why: Q },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => cn({ do: "reach" }), why: Q },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => ba.value = ba.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: mr, why: Q },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => gt("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => Sa.value = !Sa.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => xa.value = xa.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => Pa.value = Pa.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => wa.value = !wa.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => va.value = !va.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => $a.value = $a.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => Ma.value = !Ma.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => or.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => ze.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => ze.value = "palette" }
];
sr(Sr);
function ft() {
  return [...(ur.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...fr.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as Cr, comparing as $r, digits as Lr, fitted as Pr, useEffect as Vr, useRef as Tr, viewSize as Er, wipeAt as hn } from "./desk.js";
import { Fragment as Ar, jsx as gn, jsxs as Rr } from "./desk.js";
function Ir() {
  let e = $r.value, t = Cr.value, n = Tr(null);
  if (Vr(() => {
    let i = n.current;
    !i || !t || (i.width = t.picture.width, i.height = t.picture.height, i.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = Er.value, o = hn.value, r = Pr(t.picture.width, t.picture.height), l = Math.max(0, Math.min(1, (o * a - r.x) / (t.picture.width * r.scale))), c = (i) => {
    let s = i.currentTarget;
    if (i.stopPropagation(), i.type === "pointerdown") s.setPointerCapture(i.pointerId);
    else if (s.hasPointerCapture(i.pointerId)) {
      let u = s.parentElement.getBoundingClientRect();
      hn.value = Math.max(0, Math.min(1, (i.clientX - u.left) / u.width));
    }
  }, p = (i) => {
    let s = { ArrowLeft: -0.02, ArrowRight: 0.02 }[i.key];
    s && (i.stopPropagation(), i.preventDefault(), hn.value = Math.max(0, Math.min(1, o + s)));
  };
  return Rr(Ar, { children: [
    gn(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * l}% 0 0)` : "none" }
      }
    ),
    gn("span", { class: "tag left", children: "before" }),
    e === "wipe" && gn(
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
        "aria-valuetext": `${Lr(o * 100)} % before`,
        style: { left: `${100 * o}%` },
        onPointerDown: c,
        onPointerMove: c,
        onKeyDown: p
      }
    )
  ] });
}

// src/later/handles.tsx
import {
  add as Ha,
  chosenLamps as Kr,
  computed as vn,
  editor as Br,
  effect as Ur,
  fitted as _r,
  Gesture as jr,
  handles as zr,
  lamps as yt,
  lookOnly as Xr,
  middle as Qr,
  nameOf as Yr,
  normal as Zr,
  pinhole as Jr,
  positionOf as Oa,
  role as ei,
  selection as ti,
  shown as ni,
  sub as ai,
  things as kt,
  titleOf as oi,
  tool as li,
  turn as Na,
  useEffect as ri,
  useRef as ii,
  viewSize as si
} from "./desk.js";

// src/later/gizmo.ts
import { project as Ia, ray as qr } from "./desk.js";
import { across as Fr, add as le, cross as Hr, distance as Nr, dot as de, length as Or, normal as bn, scale as re, sub as Te } from "./desk.js";
var Dr = "http://www.w3.org/2000/svg", fn = 84, Me = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], vt = ["x", "y", "z"], Aa = 0.1, Wr = 5 * Math.PI / 180, Ra = 48;
function Fa(e, t) {
  let n = (m, b, k) => {
    let w = document.createElementNS(Dr, m);
    return w.setAttribute("class", k), b.append(w), w;
  }, a = (m, b, k) => {
    let w = n("g", e, `handle ${m} ${vt[b] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), r = Me.map((m, b) => a("ring", b, `ring-${vt[b]}`)), l = Me.map((m, b) => a("plane", b, `plane-${vt[b]}`)), c = Me.map((m, b) => a("arrow", b, `move-${vt[b]}`)), p = a("centre", -1, "move-view"), i = a("aim", -1, "aim"), s = n("text", e, "handle-text"), u = (m, b) => {
    let [k, w, E] = Ia(m.hole, b);
    return E < 0.02 && !m.hole.parallel ? null : [m.fit.x + k * m.fit.scale, m.fit.y + w * m.fit.scale];
  }, h = (m, b) => {
    let k = Ia(m.hole, b)[2];
    return fn / m.fit.scale * m.hole.pixel * (m.hole.parallel ? 1 : Math.max(k, 0.02));
  }, d = (m, b, k = !1) => {
    let w = b.filter(($) => $ !== null), E = w.length < b.length || w.length < 2 ? "" : `M${w.map(($) => `${$[0].toFixed(1)} ${$[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    m.setAttribute("d", E);
  }, v = (m, b, k) => {
    m.setAttribute("d", b ? `M${b[0] - k} ${b[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, f = (m, b) => m.forEach((k) => k.group.classList.toggle("gone", !b));
  function T(m, b) {
    let k = m.position, w = u(b, k), E = h(b, k), $ = m.mode === "move";
    f([...c, ...l, p], $ && w !== null), f(r, !$ && w !== null && m.turns);
    let j = m.aim ?? (m.direction ? le(k, re(m.direction, 3 * E)) : null);
    if (f([i], j !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    Me.forEach((W, U) => {
      let R = u(b, le(k, re(W, E))), ot = R ? Math.hypot(R[0] - w[0], R[1] - w[1]) < 12 : !0;
      if (c[U].group.classList.toggle("gone", !$ || ot), R && $) {
        let [ye, We] = [(R[0] - w[0]) / fn, (R[1] - w[1]) / fn], rt = Math.hypot(ye, We) || 1, [ce, Ge] = [ye / rt, We / rt], nn = [w[0] + 14 * ce, w[1] + 14 * Ge];
        d(c[U].hit, [nn, R]), c[U].seen.setAttribute("d", `M${nn[0].toFixed(1)} ${nn[1].toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}M${(R[0] - 9 * ce - 4.5 * Ge).toFixed(1)} ${(R[1] - 9 * Ge + 4.5 * ce).toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}L${(R[0] - 9 * ce + 4.5 * Ge).toFixed(1)} ${(R[1] - 9 * Ge - 4.5 * ce).toFixed(1)}`);
      }
      let [Oe, De] = [Me[(U + 1) % 3], Me[(U + 2) % 3]], Z = Math.abs(de(W, b.hole.parallel ? b.hole.forward : bn(Te(k, b.hole.eye)))) < 0.15;
      l[U].group.classList.toggle("gone", !$ || Z);
      let lt = (ye, We) => u(b, le(k, le(re(Oe, ye * E), re(De, We * E)))), aa = [lt(0.3, 0.3), lt(0.5, 0.3), lt(0.5, 0.5), lt(0.3, 0.5)];
      if (d(l[U].hit, aa, !0), d(l[U].seen, aa, !0), !$) {
        let ye = Array.from({ length: Ra + 1 }, (We, rt) => {
          let ce = 2 * Math.PI * rt / Ra;
          return u(b, le(k, le(re(Oe, Math.cos(ce) * E), re(De, Math.sin(ce) * E))));
        });
        d(r[U].hit, ye), d(r[U].seen, ye);
      }
    }), v(p.hit, w, 13), v(p.seen, w, 7);
    let A = j && u(b, j);
    d(o, [w, A]), v(i.hit, A, 16), i.seen.setAttribute("d", A ? `M${A[0] - 8} ${A[1]}h16M${A[0]} ${A[1] - 8}v16M${A[0] - 5} ${A[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let F = t.effect(() => {
    let m = t.target.value, b = t.view.value;
    e.classList.toggle("empty", !m || !b), m && b && T(m, b);
  }), ee = (m, b, k) => qr(m.hole, (b.clientX - k.left - m.fit.x) / m.fit.scale, (b.clientY - k.top - m.fit.y) / m.fit.scale);
  function ve(m, b, k) {
    m.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let E = t.view.peek();
      if (!E || !t.target.peek()) return;
      let $ = e.getBoundingClientRect(), j = k(E), A = t.hold(b), W = ee(E, w, $);
      j(W, !1, { ...A, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), m.setPointerCapture(w.pointerId), m.classList.add("held");
      let U = (Z) => {
        s.textContent = j(ee(E, Z, $), Z.ctrlKey || Z.metaKey, A), s.setAttribute("x", String(Z.clientX - $.left + 16)), s.setAttribute("y", String(Z.clientY - $.top - 12));
      }, R = (Z) => {
        m.removeEventListener("pointermove", U), m.removeEventListener("pointerup", ot), m.removeEventListener("pointercancel", Oe), removeEventListener("keydown", De, !0), m.classList.remove("held"), s.textContent = "", Z ? A.end() : A.cancel();
      }, ot = () => R(!0), Oe = () => R(!1), De = (Z) => {
        Z.key === "Escape" && (Z.stopPropagation(), R(!1));
      };
      m.addEventListener("pointermove", U), m.addEventListener("pointerup", ot), m.addEventListener("pointercancel", Oe), addEventListener("keydown", De, !0);
    });
  }
  let en = (m, b, k) => k ? Math.round(m / b) * b : m, tn = (m) => m.map((b) => b.toFixed(2)).join("  ") + " m";
  Me.forEach((m, b) => {
    ve(c[b].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (E, $, j) => {
        let A = Gr(k, m, E);
        w ??= A;
        let W = re(m, en(A - w, Aa, $));
        return j.move(W), tn(W);
      };
    }), ve(l[b].group, "move", () => ta(m)), ve(r[b].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (E, $, j) => {
        let A = qa(k.position, m, E), W = A && bn(Te(A, k.position), Fr(m));
        if (!W) return "";
        w.at ??= W;
        let U = Math.atan2(de(m, Hr(w.at, W)), de(w.at, W)), R = en(U, Wr, $);
        return j.rotate(m, R), `${(R * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), ve(p.group, "move", (m) => ta(m.hole.forward)), ve(i.group, "aim", (m) => {
    let b = t.target.peek(), k = b.aim ?? le(b.position, re(b.direction, 3 * h(m, b.position))), w = na(k, m.hole.forward);
    return (E, $, j) => {
      let A = w(E, $), W = le(k, A);
      return Nr(W, b.position) > 1e-3 && j.turn(bn(Te(W, b.position)), W), tn(W);
    };
  });
  function ta(m) {
    let b = na(t.target.peek().position, m);
    return (k, w, E) => {
      let $ = b(k, w);
      return E.move($), tn($);
    };
  }
  function na(m, b) {
    let k = null;
    return (w, E) => {
      let $ = qa(m, b, w);
      return $ ? (k ??= $, Te($, k).map((j) => en(j, Aa, E))) : [0, 0, 0];
    };
  }
  return { stop: F };
}
function Gr(e, t, n) {
  let a = Te(e, n.origin), o = de(t, n.direction), r = 1 - o * o;
  return r < 1e-6 ? 0 : (o * de(n.direction, a) - de(t, a)) / r;
}
function qa(e, t, n) {
  let a = de(t, n.direction);
  if (Math.abs(a) < 1e-4 * Or(t)) return null;
  let o = de(Te(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : le(n.origin, re(n.direction, o));
}

// src/later/handles.tsx
import { jsx as gi } from "./desk.js";
function ui([e, t, n, a], [o, r, l, c]) {
  return [
    a * o + e * c + t * l - n * r,
    a * r - e * l + t * c + n * o,
    a * l + e * r - t * o + n * c,
    a * c - e * o - t * r - n * l
  ];
}
var ci = () => !Xr.value && ei.value !== "watch" && Br.value.you && li.value !== "aim", Da = vn(() => {
  let e = ti.value;
  if (!e || !ci()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => kt.get(a) && !kt.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = Kr.value.filter((n) => Oa(yt.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), Wa = (e) => {
  let t = kt.get(e);
  return t?.place?.position ?? (t?.box ? Qr(t.box) : null);
}, pi = vn(() => {
  let e = Da.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? Oa(yt.get(t)) : Wa(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? yt.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: zr.value
  };
}), di = vn(() => {
  let e = ni.value;
  if (si.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: Jr(e.camera, t, n), fit: _r(t, n) };
}), mi = {
  effect: Ur,
  target: pi,
  view: di,
  hold(e) {
    let t = Da.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? oi(n) : n.length === 1 ? Yr("thing", n[0]) : `${n.length} things`, r = new jr(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), l = a === "lamps" ? je(n) : new Map(n.map((i) => [i, Wa(i)])), c = new Map(n.map((i) => [i, (a === "lamps" ? yt : kt).get(i)?.place])), p = (i) => {
      let s = n.map((u) => [u, i(u)]).filter(([, u]) => u);
      r.set({ [a]: Object.fromEntries(s.map(([u, h]) => [u, { place: h }])) });
    };
    return {
      move: (i) => a === "lamps" ? r.set(_e(n, i, l)) : p((s) => ({ position: Ha(l.get(s), i) })),
      turn: (i, s) => p((u) => c.get(u)?.direction ? { direction: i, ...s ? { aim: s } : {} } : null),
      rotate: (i, s) => p((u) => {
        let h = c.get(u);
        if (h?.direction) {
          let f = Zr(Na(h.direction, i, s)), T = h.aim && h.position ? Na(ai(h.aim, h.position), i, s) : null;
          return { direction: f, ...T ? { aim: Ha(h.position, T) } : {} };
        }
        let d = Math.sin(s / 2), v = [i[0] * d, i[1] * d, i[2] * d, Math.cos(s / 2)];
        return { rotation: ui(v, h?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => r.end(),
      cancel: () => r.cancel()
    };
  }
};
function hi() {
  let e = ii(null);
  return ri(() => Fa(e.current, mi).stop, []), gi("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as Ko, deselect as ws, Icon as Wn, penless as Gn, selection as xs, signal as Ms } from "./desk.js";

// src/later/measure.tsx
import {
  add as xi,
  deselect as Ja,
  digits as Se,
  dot as Mi,
  edit as Lt,
  grids as Si,
  Icon as eo,
  length as $t,
  luxText as Ae,
  maintenance as xn,
  meters as Ci,
  scale as $i,
  selection as to,
  up as Ya
} from "./desk.js";

// src/later/figures.tsx
import { maintenance as Ka, status as yn } from "./desk.js";

// src/later/verdict.ts
function Ga(e, t) {
  let n = ({ value: o, error: r, least: l }) => {
    let c = t ? 0 : r ?? 1 / 0;
    return o - c >= l ? "met" : o + c < l ? "missed" : "open";
  }, a = e.map(n);
  return a.includes("missed") ? "missed" : a.includes("open") ? "open" : "met";
}

// src/later/figures.tsx
import { jsx as Xa } from "./desk.js";
var Ba = () => yn.value?.stage === "moving" || yn.value?.stage === "loading", bi = () => Ba() || yn.value?.stage === "refining", Ua = { meter: 0.02, grid: 0.05 };
function _a(e, t, n) {
  return e == null || t == null || t > n * e || bi();
}
var wt = ({ lux: e }) => _a(e?.[0], e?.[1], Ua.meter), xt = ({ mean: e, error: t }) => _a(e, t, Ua.grid), ja = (e, t) => Ba() ? "open" : Ga(e, t === !0);
function Mt({ lux: e, target: t, done: n }) {
  if (!e || !t) return null;
  let a = Ka.value;
  return ja([{ value: e[0] * a, error: e[1] == null ? null : e[1] * a, least: t }], n);
}
function St({ mean: e, error: t, uniformity: n, uniformity_error: a, target: o, done: r }) {
  if (!o || e == null || n == null) return null;
  let l = Ka.value;
  return ja([
    { value: e * l, error: t == null ? null : t * l, least: o.lux },
    { value: n, error: a ?? null, least: o.uniformity }
  ], r);
}
var za = {
  met: ["✓", "reaches its target"],
  missed: ["✗", "misses its target"],
  open: ["≈", "within its ± of the target: not decided yet"]
};
function kn({ of: e }) {
  if (!e) return null;
  let [t, n] = za[e];
  return Xa("b", { class: e, role: "img", "aria-label": n, title: n, children: t });
}
function wn({ of: e }) {
  if (!e) return null;
  let [t, n] = za[e];
  return Xa("p", { class: e, children: `${t} ${n[0].toUpperCase()}${n.slice(1)}` });
}

// src/later/parts.tsx
import { Field as Qa, Gesture as fi, Range as vi, stroke as yi, useRef as ki } from "./desk.js";
import { jsx as ie, jsxs as Ct } from "./desk.js";
function q({ title: e, note: t, children: n }) {
  return Ct("section", { class: "part", "aria-label": e, children: [
    Ct("h3", { children: [
      e,
      t && ie("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function K(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function I(e) {
  return Ct("label", { class: "line", children: [
    ie("span", { children: e.label }),
    ie(Qa, { ...e, label: e.name ?? e.label })
  ] });
}
function wi(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function J({ label: e, names: t, quantity: n, value: a, set: o, step: r, disabled: l }) {
  let c = t ?? ["X", "Y", "Z"];
  return Ct("div", { class: "line", role: "group", "aria-label": e, children: [
    ie("span", { children: e }),
    ie("span", { class: "triple", children: c.map((p, i) => ie(
      Qa,
      {
        label: `${e} ${p}`,
        quantity: n,
        value: a[i],
        text: wi(a[i], n),
        step: r,
        disabled: l,
        set: (s) => o(i, s)
      },
      p
    )) })
  ] });
}
function Ee({ label: e, name: t, value: n, text: a, patch: o, reset: r, notch: l, class: c, style: p, disabled: i }) {
  let s = ki(null), u = (d) => () => {
    s.current?.[d](), s.current = null;
  }, h = (d) => s.current ? s.current.set(o(d)) : yi(e + t, t, o(d));
  return ie(
    vi,
    {
      label: e,
      value: n,
      text: a,
      notch: l,
      class: c,
      gradient: p,
      disabled: i,
      begin: () => s.current = new fi(t),
      on: h,
      end: u("end"),
      cancel: u("cancel"),
      reset: r === void 0 ? void 0 : () => h(r)
    }
  );
}
function Ie({ value: e, label: t, set: n }) {
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
import { Fragment as Mn, jsx as S, jsxs as _ } from "./desk.js";
var Li = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function no() {
  let e = to.value?.ids[0], t = Ci.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: r, done: l, ...c } = { ...t, ...o };
    Lt(`${t.name}: ${a}`, { meters: { [e]: c } });
  };
  return _(Mn, { children: [
    S("header", { class: "panel-head", children: S(Ie, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    S("p", { class: `crumbs ${wt(t) ? "unsettled" : "known"}`, children: t.lux?.[1] != null ? `${Ae(t.lux[0] * xn.value)} ±${Ae(t.lux[1] * xn.value, !1)}` : "measuring" }),
    S("div", { class: "scroll", children: _(q, { title: "Meter", children: [
      _("label", { class: "line", children: [
        S("span", { children: "Measures" }),
        S("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: Li.map(([a, o]) => S("option", { value: a, children: o }, a)) })
      ] }),
      S(J, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: se(t.point, a, o) }) }),
      S(I, { label: "At least", quantity: "lux", step: 50, value: t.target ?? 0, set: (a) => n("target", { target: a(t.target ?? 0) || null }) }),
      S(wn, { of: Mt(t) }),
      S(J, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: se(t.normal, a, o) }) }),
      _("button", { class: "plain full", onClick: () => {
        Ja(), Lt(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        S(eo, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var Za = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function ao() {
  let e = to.value?.ids[0], t = Si.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This grid is gone." });
  let n = xn.value, a = (i, s) => {
    let { name: u, corner: h, u: d, v, normal: f, columns: T, rows: F, border: ee, target: ve } = { ...t, ...s };
    Lt(`${t.name}: ${i}`, { grids: { [e]: { name: u, corner: h, u: d, v, normal: f, columns: T, rows: F, border: ee, target: ve } } });
  }, o = (i, s = t.border) => {
    let [u, h] = ln([it($t(t.u), s), it($t(t.v), s)]);
    a(i, { columns: u, rows: h, border: s });
  }, r = Mi(t.corner, Ya.value) - st(), l = (i, s, u) => _(Mn, { children: [
    S("dt", { children: i }),
    S("dd", { children: s == null ? "…" : u(s) })
  ] }), c = (i, s) => i == null ? "" : ` ±${s(i)}`, p = t.target ?? { lux: 500, uniformity: 0.6 };
  return _(Mn, { children: [
    S("header", { class: "panel-head", children: S(Ie, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    _("p", { class: "crumbs", children: [
      Se($t(t.u), 2),
      " × ",
      Se($t(t.v), 2),
      " m, ",
      Se(t.columns * t.rows),
      " points"
    ] }),
    _("div", { class: "scroll", children: [
      S(q, { title: "Figures", note: n === 1 ? "new" : `× ${Se(n, 2)}`, children: _("dl", { class: `figures ${xt(t) ? "unsettled" : ""}`, children: [
        l("Ē", t.mean, (i) => Ae(i * n) + c(t.error, (s) => Ae(s * n, !1))),
        l("E min", t.min, (i) => Ae(i * n)),
        l("E max", t.max, (i) => Ae(i * n)),
        l("U₀ = min / mean", t.uniformity, (i) => Se(i, 2) + c(t.uniformity_error, (s) => Se(s, 2))),
        l("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => Se(i, 2))
      ] }) }),
      _(q, { title: "Target", children: [
        S(wn, { of: St(t) }),
        _("label", { class: "line", children: [
          S("span", { children: "Class" }),
          _("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let s = Za[Number(i.currentTarget.value)];
            a("target", { target: s ? { lux: s[1], uniformity: s[2] } : null });
          }, children: [
            S("option", { value: "", children: t.target ? "choose…" : "none" }),
            Za.map(([i, s, u], h) => _("option", { value: h, children: [
              i,
              ": ",
              s,
              " lx, U₀ ",
              u
            ] }, i)),
            S("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        S(I, { label: "Ē at least", quantity: "lux", step: 50, value: p.lux, set: (i) => a("target", { target: { ...p, lux: i(p.lux) } }) }),
        S(I, { label: "U₀ at least", quantity: "share", step: 0.05, value: p.uniformity, set: (i) => a("target", { target: { ...p, uniformity: i(p.uniformity) } }) })
      ] }),
      _(q, { title: "Area", children: [
        S(J, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, s) => a("move", { corner: se(t.corner, i, s) }) }),
        S(I, { label: "Above the floor", quantity: "length", step: 0.01, value: r, set: (i) => a("height", { corner: xi(t.corner, $i(Ya.value, i(r) - r)) }) }),
        S(I, { label: "Border", quantity: "length", step: 0.05, value: t.border ?? 0, set: (i) => o("border", Math.max(0, i(t.border ?? 0))) }),
        S(I, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        S(I, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        S("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: () => o("standard spacing"), children: "Spacing of the standard" }),
        _("button", { class: "plain full", onClick: () => {
          Ja(), Lt(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          S(eo, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as he,
  chosenLamps as Wi,
  dot as Pn,
  edit as Tt,
  format as go,
  groups as Et,
  handles as Pt,
  Icon as qe,
  lamps as In,
  layers as Gi,
  lumensOf as Ki,
  normal as bo,
  output as Bi,
  percent as En,
  positionOf as so,
  selection as Vn,
  signal as fo,
  spot as Ui,
  sub as uo,
  titleOf as An,
  tool as vo,
  toLevel as co,
  toTravel as _i,
  typeLevel as Tn,
  up as ji,
  Fade as zi,
  Field as Xi,
  wantLevel as po,
  compass as yo,
  add as It,
  scale as Fe,
  length as Qi,
  Range as Yi,
  strokeLevel as mo,
  useRef as Zi
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as Ei,
  digits as lo,
  edit as Ii,
  fromHex as Ai,
  hex as Ri,
  lamps as ro,
  mired as Ce,
  titleOf as qi
} from "./desk.js";

// src/later/white.ts
import { css as Pi, mired as Sn } from "./desk.js";
function Vi(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((r) => Math.max(0, r));
}
function Ti(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function oo(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, r) => {
    let l = Sn(e) + (Sn(t) - Sn(e)) * r / (n - 1);
    return Pi(Vi(...Ti(1e6 / l)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as $n, jsx as O, jsxs as me } from "./desk.js";
var Qe = 1800, Ln = 1e4, Fi = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], Hi = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], Ni = oo(Qe, Ln), Cn = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(ro.get(n).color) }]))
}), Oi = (e) => {
  let t = 1e6 / (Ce(Qe) + (Ce(Ln) - Ce(Qe)) * e);
  return Math.round(t / 10) * 10;
}, Di = (e) => (Ce(e) - Ce(Qe)) / (Ce(Ln) - Ce(Qe));
function io() {
  let e = Ei.value, t = e.map((l) => ro.get(l)?.color).filter((l) => l !== void 0);
  if (!t.length) return null;
  let n = K(t.map((l) => l.mode)), a = t[0], o = qi(e), r = (l, c) => Ii(`${o}: ${l}`, Cn(e, c));
  return me($n, { children: [
    me("div", { class: "line", children: [
      O("span", { children: "Colour" }),
      O("div", { class: "segments", role: "group", "aria-label": "Colour by", children: Hi.map(([l, c]) => O("button", { "aria-pressed": n === l, onClick: () => r(`colour by ${c}`, () => ({ mode: l })), children: c }, l)) })
    ] }),
    n === "kelvin" && me($n, { children: [
      me("div", { class: "line slide", children: [
        O("span", { children: "White" }),
        O(
          Ee,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: Ni,
            value: Di(a.kelvin),
            text: `${lo(a.kelvin)} kelvin`,
            patch: (l) => Cn(e, () => ({ mode: "kelvin", kelvin: Oi(l) }))
          }
        )
      ] }),
      O(
        I,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: K(t.map((l) => l.kelvin)),
          step: 50,
          set: (l) => r("white", (c) => ({ mode: "kelvin", kelvin: l(c.kelvin) }))
        }
      ),
      O("div", { class: "whites", role: "group", "aria-label": "Whites", children: Fi.map(([l, c]) => O("button", { title: c, "aria-label": `${l} kelvin, ${c}`, onClick: () => r(`${l} K`, () => ({ mode: "kelvin", kelvin: l })), children: l }, l)) }),
      me("div", { class: "line slide", children: [
        O("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        O(
          Ee,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${lo(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (l) => Cn(e, () => ({ tint: Math.round((l * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      O(I, { label: "", name: "Tint, typed", quantity: "number", value: K(t.map((l) => l.tint)), step: 1, set: (l) => r("tint", (c) => ({ tint: Math.max(-50, Math.min(50, l(c.tint))) })) })
    ] }),
    n === "rgb" && me($n, { children: [
      me("label", { class: "line", children: [
        O("span", { children: "Colour" }),
        O("input", { type: "color", class: "pick", "aria-label": "Colour", value: Ri(a.rgb), onChange: (l) => r("colour", () => ({ mode: "rgb", rgb: Ai(l.currentTarget.value) })) })
      ] }),
      O(
        J,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (l, c) => r("colour", (p) => ({ rgb: p.rgb.map((i, s) => s === l ? Math.max(0, c(i)) : i) }))
        }
      )
    ] }),
    n === "xy" && me("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      O("span", { children: "x, y" }),
      O("span", { class: "triple", children: [0, 1].map((l) => O(
        I,
        {
          label: "xy"[l],
          quantity: "number",
          step: 1e-3,
          value: K(t.map((c) => c.xy[l])),
          set: (c) => r("chromaticity", (p) => ({ xy: p.xy.map((i, s) => s === l ? Math.max(0.01, Math.min(0.9, c(i))) : i) }))
        },
        l
      )) })
    ] }),
    n === null && O("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as Rn, jsx as y, jsxs as D } from "./desk.js";
var Re = fo(1), Vt = fo([1, 0, 0]), Ji = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], At = 180 / Math.PI;
function ho(e, t) {
  let { right: n, ahead: a } = yo(t), o = -Pn(e, t);
  return [Math.atan2(Pn(e, n), Pn(e, a)) * At, Math.asin(Math.max(-1, Math.min(1, o))) * At];
}
function es(e, t, n) {
  let { right: a, ahead: o } = yo(n), [r, l] = [e / At, t / At], c = It(Fe(a, Math.sin(r)), Fe(o, Math.cos(r)));
  return bo(It(Fe(c, Math.cos(l)), Fe(n, -Math.sin(l))));
}
function ts({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction);
  return D("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    D("button", { "aria-pressed": vo.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => he("aim"), children: [
      y(qe, { name: "aim" }),
      "Aim"
    ] }),
    y("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => he("solo"), children: y(qe, { name: "solo" }) }),
    y("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => he("from-lamp"), children: y(qe, { name: "eye" }) }),
    y("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => he("frame"), children: y(qe, { name: "frame" }) }),
    y("span", { class: "gap" }),
    y("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => he("park"), children: "Park" }),
    y("button", { class: "icon", "aria-label": `Remove ${An(e)}`, title: "Remove (Del)", onClick: () => he("remove"), children: y(qe, { name: "bin" }) })
  ] });
}
function ns({ ids: e, all: t }) {
  let n = K(t.map((l) => l.level)), a = Ki(e), o = t.every((l) => l.free), r = e[e.length - 1];
  return D(q, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    D("div", { class: "line slide", children: [
      y("span", { children: "Level" }),
      y(as, { id: r })
    ] }),
    D("label", { class: "line", children: [
      y("span", {}),
      y(
        Xi,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: K(t.map((l) => l.flux)) ?? void 0,
          step: 0.01,
          set: (l) => Tn(e, l),
          open: po.value,
          opened: () => po.value = "",
          id: "level"
        }
      )
    ] }),
    y(
      I,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (l) => Tn(e, (c, p) => l(c * p) / p)
      }
    ),
    D("div", { class: "line", children: [
      y("span", { children: "Stops" }),
      y("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: Ji.map(([l, c]) => y("button", { "aria-label": `${c} stop`, onClick: () => Tn(e, (p) => Math.min(1e3, p * 2 ** l)), children: c }, c)) })
    ] }),
    D("p", { class: "sum", children: [
      go(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (Et.get(t[0].group)?.level ?? 1) !== 1 && ` (${En(t[0].level)} % × ${En(Et.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    y(io, {})
  ] });
}
function as({ id: e }) {
  let t = Zi(null), n = In.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (r) => () => {
    t.current?.[r](), t.current = null;
  };
  return y(
    Yi,
    {
      label: "Level",
      value: _i(n.level),
      text: `${En(n.level)} %, ${go(n.flux * Bi(n), "flux")}`,
      begin: () => t.current = new zi(a),
      on: (r) => t.current ? t.current.to(co(r)) : mo(a, co(r)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => mo(a, 1)
    }
  );
}
function Ye(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = In.get(o), l = n(r.place ?? {}, r);
    l && (a[o] = { place: l });
  }
  Object.keys(a).length && Tt(`${An(e)}: ${t}`, { lamps: a });
}
function os({ ids: e, all: t }) {
  let n = (o) => K(t.map((r) => r.place?.[o] ?? null)), a = (o) => t.some((r) => r.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : D(q, { title: "Beam", note: "re-trace", children: [
    a("outer") && D(Rn, { children: [
      y(I, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => Ye(e, "beam", (r) => r.outer == null ? null : { inner: Math.max(0.1, Math.min(r.outer, o(r.inner ?? r.outer))) }) }),
      y(I, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => Ye(e, "beam", (r) => {
        if (r.outer == null) return null;
        let l = Math.max(0.2, Math.min(179, o(r.outer)));
        return { outer: l, inner: Math.min(r.inner ?? l, l) };
      }) })
    ] }),
    a("radius") && y(I, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => Ye(e, "radius", (r) => r.radius == null ? null : { radius: Math.max(1e-3, o(r.radius)) }) })
  ] });
}
function ls({ ids: e, all: t }) {
  let n = t.filter((u) => so(u) !== null);
  if (!n.length) return null;
  let a = n.map((u) => so(u)), o = (u, h) => K(h.map((d) => Math.round(d[u] * 1e4) / 1e4)), r = t.filter((u) => u.place?.direction), l = ji.value, c = r.map((u) => ho(u.place?.direction, l).map((h) => Math.round(h * 10) / 10)), p = t.map((u) => u.place?.aim).filter((u) => !!u), i = (u, h) => {
    let d = je(e), v = {};
    for (let [f, T] of d) {
      let F = [0, 0, 0];
      F[u] = h(T[u]) - T[u], Object.assign(v, _e([f], F, d).lamps);
    }
    Tt(`Move ${An(e)}`, { lamps: v });
  }, s = (u, h) => Ye(e, u ? "tilt" : "pan", (d) => {
    if (!d.direction) return null;
    let v = ho(d.direction, l);
    v[u] = h(v[u]);
    let f = es(v[0], Math.max(-90, Math.min(90, v[1])), l), T = d.aim && d.position ? Qi(uo(d.aim, d.position)) : 0;
    return { direction: f, ...T && d.position ? { aim: It(d.position, Fe(f, T)) } : {} };
  });
  return D(q, { title: "Place", note: "re-trace", children: [
    y(J, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((u) => o(u, a)), set: i }),
    r.length > 0 && D(Rn, { children: [
      y(I, { label: "Pan", quantity: "angle", step: 1, value: K(c.map((u) => u[0])), set: (u) => s(0, u) }),
      y(I, { label: "Tilt", quantity: "angle", step: 1, value: K(c.map((u) => u[1])), set: (u) => s(1, u) }),
      y(
        J,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: p.length ? [0, 1, 2].map((u) => o(u, p)) : [NaN, NaN, NaN],
          set: (u, h) => Ye(e, "aim", (d) => {
            if (!d.direction || !d.position) return null;
            let v = se(d.aim ?? It(d.position, Fe(d.direction, 2)), u, h);
            return { aim: v, direction: bo(uo(v, d.position)) };
          })
        }
      )
    ] }),
    D("div", { class: "line", children: [
      y("span", { children: "Handles" }),
      D("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        y("button", { "aria-pressed": Pt.value === "move", onClick: () => Pt.value = "move", children: "Move" }),
        y("button", { "aria-pressed": Pt.value === "turn", onClick: () => Pt.value = "turn", children: "Turn" })
      ] })
    ] }),
    y("button", { class: "plain full", "aria-pressed": vo.value === "place", onClick: () => he("place"), children: "Put on a surface by pointing" }),
    r.length > 0 && Ui.value && y("button", { class: "plain full", onClick: () => he("aim-here"), children: "Aim at the last point" })
  ] });
}
function rs({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : D(q, { title: "Copies along a line", children: [
    y(I, { label: "How many", quantity: "number", step: 1, value: Re.value, set: (n) => Re.value = Math.max(1, Math.min(100, Math.round(n(Re.value)))) }),
    y(J, { label: "Step", quantity: "length", step: 0.05, value: Vt.value, set: (n, a) => Vt.value = se(Vt.value, n, a) }),
    D("button", { class: "plain full", onClick: () => ht(e, Re.value, Vt.value), children: [
      y(qe, { name: "copy" }),
      Re.value === 1 ? "One copy" : `${Re.value} copies`
    ] })
  ] });
}
function ko() {
  let e = Wi.value, t = e.map((l) => In.get(l)).filter((l) => !!l);
  if (!t.length) return y("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && Et.get(n.group), o = Vn.value?.kind === "group" ? Et.get(Vn.value.ids[0]) : void 0, r = n?.layer != null ? Gi.value[n.layer] : void 0;
  return D(Rn, { children: [
    y("header", { class: "panel-head", children: n ? y(Ie, { label: "Name of the lamp", value: n.name, set: (l) => Tt(`Rename ${n.name}`, { lamps: { [e[0]]: { name: l } } }) }) : o ? y(Ie, { label: "Name of the group", value: o.name, set: (l) => Tt(`Rename ${o.name}`, { groups: { [Vn.value.ids[0]]: { name: l } } }) }) : D("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    y("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((l) => l.on).length} of ${t.length} on` }),
    D("div", { class: "scroll", children: [
      y(ts, { ids: e, all: t }),
      y(ns, { ids: e, all: t }),
      y(q, { title: "Photometry", children: y("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      y(os, { ids: e, all: t }),
      y(ls, { ids: e, all: t }),
      y(rs, { ids: e, all: t }),
      y("p", { class: "cost", children: t.every((l) => l.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as qn,
  candles as Rt,
  command as is,
  digits as Ft,
  edit as wo,
  Field as xo,
  filterOf as $o,
  go as ss,
  history as us,
  hovered as Mo,
  Icon as Ht,
  layers as cs,
  lookOnly as So,
  maintenance as He,
  materials as ps,
  percent as ds,
  scene as ms,
  select as Lo,
  signal as hs,
  singleKeys as Co,
  sub as gs,
  things as bs,
  travel as qt,
  Virtual as Po,
  workPlane as Fn
} from "./desk.js";
import { Fragment as fs, jsx as x, jsxs as V } from "./desk.js";
function Vo() {
  let e = ms.value;
  if (!e) return null;
  let t = gs(e.bounds[1], e.bounds[0]);
  return V(fs, { children: [
    V(q, { title: "Room", children: [
      V("p", { children: [
        t.map((n) => Ft(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${Ft(e.triangles)} triangles` : ""
      ] }),
      x("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && x("ul", { class: "buttons", children: e.cameras.map((n, a) => x("li", { children: x("button", { onClick: () => ss(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && V("details", { children: [
        V("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        x("ul", { class: "remarks", children: e.warnings.map((n) => x("li", { children: n }, n)) })
      ] })
    ] }),
    V(q, { title: "Figures", children: [
      V("label", { class: "line", children: [
        x("span", { children: "Maintenance" }),
        x(xo, { label: "Maintenance factor", quantity: "share", value: He.value, step: 0.05, set: (n) => He.value = Math.max(0.1, Math.min(1, n(He.value))) })
      ] }),
      V("p", { class: "quiet", children: [
        He.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        He.value === 1 && x("button", { class: "plain", onClick: () => He.value = 0.8, children: "0.80" })
      ] }),
      V("label", { class: "line", children: [
        x("span", { children: "Work plane" }),
        x(xo, { label: "Work plane above the floor", quantity: "length", value: Fn.value, step: 0.05, set: (n) => Fn.value = Math.max(0, Math.min(3, n(Fn.value))) })
      ] }),
      V("div", { class: "line", children: [
        x("span", { children: "Unit" }),
        V("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          x("button", { "aria-pressed": Rt.value === "lx", onClick: () => Rt.value = "lx", children: "lx, cd/m²" }),
          x("button", { "aria-pressed": Rt.value === "fc", onClick: () => Rt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    x(q, { title: "Layers of light", children: x("ul", { class: "layers", children: cs.value.map((n, a) => V("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      x("i", { class: "dot", "aria-hidden": "true" }),
      x("span", { children: n.name || `layer ${a + 1}` }),
      x("small", { children: n.held ? "held" : ds(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    V(q, { title: "Hands", children: [
      V("div", { class: "line", children: [
        x("span", { children: "Faders" }),
        V("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          x("button", { "aria-pressed": qt.value === "square", onClick: () => qt.value = "square", children: "Square law" }),
          x("button", { "aria-pressed": qt.value === "linear", onClick: () => qt.value = "linear", children: "Even" })
        ] })
      ] }),
      V("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: Co.value, onChange: (n) => Co.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      V("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: So.value, onChange: (n) => So.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var Nt = hs("");
function To({ label: e }) {
  return x("span", { class: "field filter", children: x("input", { type: "text", "aria-label": e, placeholder: "Filter", value: Nt.value, onInput: (t) => Nt.value = t.currentTarget.value }) });
}
function Eo() {
  let e = $o(bs, Nt.value);
  return V("div", { class: "listing", children: [
    x(To, { label: "Filter things" }),
    x(
      Po,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return V("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => Mo.value = { kind: "thing", id: n }, onPointerLeave: () => Mo.value = null, children: [
            x("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => wo(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: x(Ht, { name: a.hidden ? "eye-off" : "eye" }) }),
            x("button", { class: "row-name", onClick: () => Lo("thing", n), children: x("span", { children: a.name }) }),
            x("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => wo(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: x(Ht, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function Io() {
  let e = $o(ps, Nt.value);
  return V("div", { class: "listing", children: [
    x(To, { label: "Filter materials" }),
    x(
      Po,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return V("div", { class: "sheet-row material", role: "listitem", children: [
            x("button", { class: "row-name", onClick: () => Lo("material", n), children: x("span", { children: a.name }) }),
            V("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${Ft(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function Ao() {
  let e = us.value;
  return V(q, { title: "History", children: [
    V("p", { children: [
      e.steps === 1 ? "One step" : `${Ft(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => qn("undo"), children: [
      x(Ht, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => qn("redo"), children: [
      x(Ht, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    x("button", { class: "plain full", onClick: () => qn("save"), children: "Save a version with a name…" }),
    x("button", { class: "plain full", onClick: () => is({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as Hn,
  edit as Ho,
  fromHex as vs,
  hex as ys,
  Icon as Ro,
  materials as No,
  middle as qo,
  select as Oo,
  selection as Do,
  things as Nn
} from "./desk.js";
import { Fragment as Dn, jsx as L, jsxs as z } from "./desk.js";
var On = 180 / Math.PI;
function Fo(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * On : 0;
}
function ks(e, t) {
  let n = [0, 0, 0, Math.cos(t / On / 2)];
  return n[e] = Math.sin(t / On / 2), n;
}
function Wo() {
  let e = (Do.value?.ids ?? []).filter((p) => Nn.get(p)), t = e.map((p) => Nn.get(p));
  if (!t.length) return L("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((p) => p.locked), r = (p, i) => Ho(`${a}: ${p}`, { things: Object.fromEntries(e.map((s, u) => [s, i(t[u])])) }), l = t.map((p) => p.place?.position ?? (p.box ? qo(p.box) : [0, 0, 0])), c = n.box ? [0, 1, 2].map((p) => n.box[1][p] - n.box[0][p]) : null;
  return z(Dn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: a }) }),
    c && z("p", { class: "crumbs", children: [
      c.map((p) => Hn(p, 2)).join(" × "),
      " m"
    ] }),
    z("div", { class: "scroll", children: [
      z("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        z("button", { "aria-pressed": t.every((p) => p.hidden), onClick: () => r(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          L(Ro, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        z("button", { "aria-pressed": o, onClick: () => r(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          L(Ro, { name: o ? "lock" : "unlock" }),
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
            value: [0, 1, 2].map((p) => K(l.map((i) => Math.round(i[p] * 1e4) / 1e4))),
            set: (p, i) => r("move", (s) => ({ place: { position: se(s.place?.position ?? qo(s.box), p, i) } }))
          }
        ),
        [0, 1, 2].map((p) => L(
          I,
          {
            label: `Turn ${"XYZ"[p]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: K(t.map((i) => Math.round(Fo(i.place?.rotation, p) * 10) / 10)),
            set: (i) => r("turn", (s) => ({ place: { rotation: ks(p, i(Fo(s.place?.rotation, p))) } }))
          },
          p
        )),
        L(
          I,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: o,
            value: K(t.map((p) => p.place?.scale ?? 1)),
            set: (p) => r("scale", (i) => ({ place: { scale: Math.max(1e-3, p(i.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      L(q, { title: "Materials", children: L("ul", { class: "buttons", children: n.materials.map((p) => L("li", { children: L("button", { onClick: () => Oo("material", p), children: No.get(p)?.name ?? `material ${p}` }) }, p)) }) })
    ] })
  ] });
}
function Go() {
  let e = Do.value?.ids[0], t = No.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This material is gone." });
  let n = (i, s) => Ho(`${t.name}: ${i}`, { materials: { [e]: s } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], l = ((i) => 0.2126 * i[0] + 0.7152 * i[1] + 0.0722 * i[2])(o), c = (i) => o.map((s) => Math.max(0, Math.min(1, l > 1e-4 ? s / l * i : i))), p = (i, s) => t[s] != null && z(Dn, { children: [
    z("div", { class: "line slide", children: [
      L("span", { children: i }),
      L(Ee, { label: i, name: `${t.name}: ${i.toLowerCase()}`, value: t[s], text: Hn(t[s], 2), patch: (u) => ({ materials: { [e]: { [s]: Math.round(u * 1e3) / 1e3 } } }) })
    ] }),
    L(I, { label: "", name: `${i}, typed`, quantity: "share", step: 0.01, value: t[s], set: (u) => n(i.toLowerCase(), { [s]: Math.max(0, Math.min(1, u(t[s]))) }) })
  ] });
  return z(Dn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: t.name }) }),
    L("p", { class: "crumbs", children: t.kind }),
    z("div", { class: "scroll", children: [
      z(q, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        z("div", { class: "line slide", children: [
          L("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          L(Ee, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: l, text: Hn(l, 2), patch: (i) => ({ materials: { [e]: { [a]: c(Math.min(0.95, i)) } } }) })
        ] }),
        L(I, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(l * 1e3) / 1e3, set: (i) => n("reflectance", { [a]: c(Math.min(0.98, i(l))) }) }),
        z("label", { class: "line", children: [
          L("span", { children: "Colour" }),
          L("input", { type: "color", class: "pick", "aria-label": "Colour", value: ys(o), onChange: (i) => n("colour", { [a]: vs(i.currentTarget.value) }) })
        ] }),
        p("Roughness", "roughness"),
        p("Gloss", "specular")
      ] }),
      L(q, { title: "On", children: L("ul", { class: "buttons", children: Nn.all().filter(([, i]) => i.materials.includes(e)).slice(0, 40).map(([i, s]) => L("li", { children: L("button", { onClick: () => Oo("thing", i), children: s.name }) }, i)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as Bo, jsx as H, jsxs as Ot } from "./desk.js";
var Ze = ["Scene", "Things", "Materials", "History"], ge = Ms("Scene");
function Ss() {
  let e = { Scene: Vo, Things: Eo, Materials: Io, History: Ao }[ge.value];
  return Ot(Bo, { children: [
    H("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), ge.value = Ze[(Ze.indexOf(ge.value) + a + Ze.length) % Ze.length], document.getElementById(`tab-${ge.value}`)?.focus());
    }, children: Ze.map((n) => H("button", { id: `tab-${n}`, role: "tab", "aria-selected": ge.value === n, "aria-controls": "tab-panel", tabIndex: ge.value === n ? 0 : -1, onClick: () => ge.value = n, children: n }, n)) }),
    H("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${ge.value}`, tabIndex: 0, children: H(e, {}) })
  ] });
}
function Cs() {
  let e = xs.value;
  return e ? Ot(Bo, { children: [
    Ot("nav", { class: "chooser", "aria-label": "Selection", children: [
      H("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => Ko("previous"), children: H(Wn, { name: "back" }) }),
      H("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => Ko("next"), children: H(Wn, { name: "forth" }) }),
      H("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      H("span", { class: "gap" }),
      H("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: ws, children: H(Wn, { name: "close" }) })
    ] }),
    Gn.value && H("p", { class: "penless", children: Gn.value }),
    Ot("fieldset", { class: "editing", disabled: Gn.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && H(ko, {}),
      e.kind === "thing" && H(Wo, {}),
      e.kind === "material" && H(Go, {}),
      e.kind === "meter" && H(no, {}),
      e.kind === "grid" && H(ao, {})
    ] })
  ] }) : H(Ss, {});
}

// src/later/legend.tsx
import { asked as $s, candles as Ls, display as Ps, Field as Vs, show as Ts, three as Es, useRef as Is } from "./desk.js";
import { jsx as X, jsxs as Dt } from "./desk.js";
var Kn = [1, 2, 5];
function As(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, r = 10 ** Math.floor(Math.log10(o)), l = r * (Kn.find((c) => c * r >= o) ?? 10);
    for (let c = Math.ceil(e / l) * l; c <= t * 1.0001; c += l) a.push(c);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let r of Kn) {
      let l = r * 10 ** o;
      l >= e * 0.999 && l <= t * 1.001 && a.push(l);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function Rs(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var ue = (e, t) => {
  let n = $s({ ...e, ...t });
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && Ts({ false_color: n });
};
function Uo(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return Kn[a] * 10 ** ((n - a) / 3);
}
function qs() {
  let e = Ps.value.false_color, t = Is(null);
  if (!e) return null;
  let n = Ls.value === "fc", a = e.quantity === "illuminance", o = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", r = n ? a ? 1 / 10.7639 : 0.2919 : 1, l = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, c = e.ticks ?? As(e.low, e.high, e.scale).map((s) => [s, Rs(s, e)]), p = (s) => ({
    onPointerDown: (u) => {
      u.currentTarget.setPointerCapture(u.pointerId), t.current = { y: u.clientY, end: s, from: e[s] };
    },
    onPointerMove: (u) => {
      let h = t.current;
      h?.end === s && ue(e, { [s]: Uo(h.from, Math.round((h.y - u.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (u) => {
      let h = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[u.key];
      h && (u.preventDefault(), u.stopPropagation(), ue(e, { [s]: Uo(e[s], h) }));
    }
  }), i = ({ end: s }) => Dt("div", { class: "end", children: [
    X(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": s === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[s],
        "aria-valuemin": 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${Es(e[s] * r)} ${o}`,
        ...p(s)
      }
    ),
    X(
      Vs,
      {
        label: s === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[s] * r).toPrecision(3)),
        set: (u) => ue(e, { [s]: u(e[s] * r) / r })
      }
    )
  ] });
  return Dt("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    Dt("header", { children: [
      X(
        "button",
        {
          "aria-label": `${o}: ${a ? "illuminance" : "luminance"}, change`,
          onClick: () => ue(e, { quantity: a ? "luminance" : "illuminance" }),
          children: o
        }
      ),
      X("button", { "aria-pressed": e.scale === "log", onClick: () => ue(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      X("button", { "aria-pressed": e.lines, onClick: () => ue(e, { lines: !e.lines }), children: "lines" })
    ] }),
    X(i, { end: "high" }),
    X("div", { class: "scale", style: { background: l }, children: c.map(([s, u]) => X("span", { style: { bottom: `${100 * u}%` }, children: String(Number((s * r).toPrecision(2))) }, s)) }),
    X(i, { end: "low" }),
    Dt("footer", { children: [
      X("button", { onClick: () => ue(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      X("button", { onClick: () => ue(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      X(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (s) => ue(e, { palette: s.currentTarget.value }),
          children: e.palettes?.map((s) => X("option", { children: s }, s)) ?? X("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as _n,
  act as Zo,
  ask as _s,
  command as js,
  copyText as zs,
  digits as Xs,
  go as Qs,
  hear as Ys,
  lamps as Zs,
  say as Bt,
  select as Js,
  send as Gt,
  sheet as et,
  shown as eu,
  signal as tt,
  useEffect as jn,
  useLayoutEffect as tu,
  useRef as Ut,
  walkNames as nu,
  whyNotTo as au
} from "./desk.js";

// src/later/csv.ts
import { gridPoint as Fs, grids as Hs, maintenance as Ns, meters as Os, scene as _o } from "./desk.js";
var Ds = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function Ws() {
  let e = Ns.peek(), t = [["scene", _o.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of Os.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of Hs.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, r] of Object.entries(a)) t.push([o, r == null ? null : r * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, r) => {
      let l = Fs(n, r % n.columns, Math.floor(r / n.columns));
      t.push([...l.map((c) => c.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(Ds).join(",")).join(`\r
`) + `\r
`;
}
function Bn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function jo() {
  let e = URL.createObjectURL(new Blob([Ws()], { type: "text/csv" }));
  Bn(`${_o.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var Qo = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], Wt = new Uint8Array(512), Un = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  Wt[e] = Wt[e + 255] = t, Un[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var zo = (e, t) => e && t ? Wt[Un[e] + Un[t]] : 0;
function Gs(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let r = new Array(n.length + 1).fill(0);
    n.forEach((l, c) => {
      r[c] ^= l, r[c + 1] ^= zo(l, Wt[o]);
    }), n = r;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let r = a[o];
    r && n.forEach((l, c) => a[o + c] ^= zo(l, r));
  }
  return a.slice(e.length);
}
function Ks(e, t) {
  let [n, a, o] = Qo[t - 1], r = [], l = (h, d) => {
    for (let v = d - 1; v >= 0; v--) r.push(h >> v & 1);
  };
  for (l(4, 4), l(e.length, 8), e.forEach((h) => l(h, 8)), l(0, Math.min(4, n * 8 - r.length)); r.length % 8; ) r.push(0);
  let c = [];
  for (let h = 0; h < r.length; h += 8) c.push(parseInt(r.slice(h, h + 8).join(""), 2));
  for (let h = 236; c.length < n; h ^= 253) c.push(h);
  let p = n / o, i = Array.from({ length: o }, (h, d) => c.slice(d * p, (d + 1) * p)), s = i.map((h) => Gs(h, a)), u = (h) => h[0].flatMap((d, v) => h.map((f) => f[v]));
  return [...u(i), ...u(s)];
}
var Bs = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function Us(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function Xo(e) {
  let t = e.length, n = 0, a = 0;
  for (let o of [!1, !0])
    for (let r = 0; r < t; r++) {
      let l = Array.from({ length: t }, (i, s) => o ? e[s][r] : e[r][s]), c = 1;
      for (let i = 1; i <= t; i++)
        i < t && l[i] === l[i - 1] ? c++ : (c >= 5 && (n += c - 2), c = 1);
      let p = l.map(Number).join("");
      for (let i = 0; i + 11 <= t; i++) {
        let s = p.slice(i, i + 11);
        (s === "10111010000" || s === "00001011101") && (n += 40);
      }
    }
  for (let o = 0; o < t; o++)
    for (let r = 0; r < t; r++)
      e[o][r] && a++, r && o && e[o][r] === e[o - 1][r] && e[o][r] === e[o][r - 1] && e[o][r] === e[o - 1][r - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function Yo(e) {
  let t = [...new TextEncoder().encode(e)], n = Qo.findIndex(([d]) => t.length + 2 <= d) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), r = Array.from({ length: a }, () => new Array(a).fill(!1)), l = (d, v, f) => {
    d < 0 || v < 0 || d >= a || v >= a || (o[v][d] = f, r[v][d] = !0);
  };
  for (let d = 0; d < a; d++)
    l(d, 6, d % 2 === 0), l(6, d, d % 2 === 0);
  for (let [d, v] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let f = -4; f <= 4; f++)
      for (let T = -4; T <= 4; T++) {
        let F = Math.max(Math.abs(T), Math.abs(f));
        l(d + T, v + f, F !== 2 && F !== 4);
      }
  if (n > 1) {
    let d = a - 7;
    for (let v = -2; v <= 2; v++) for (let f = -2; f <= 2; f++) l(d + f, d + v, Math.max(Math.abs(f), Math.abs(v)) !== 1);
  }
  let c = (d) => {
    let v = Us(d);
    for (let f = 0; f < 15; f++) {
      let T = (v >> f & 1) === 1, F = f < 6 ? f : f < 8 ? f + 1 : a - 15 + f;
      l(8, F, T), l(f < 8 ? a - 1 - f : f < 9 ? 7 : 14 - f, 8, T);
    }
    l(8, a - 8, !0);
  };
  c(0);
  let p = Ks(t, n), i = 0;
  for (let d = a - 1; d > 0; d -= 2) {
    d === 6 && (d = 5);
    for (let v = 0; v < a; v++)
      for (let f of [d, d - 1]) {
        let F = (d + 1 & 2) === 0 ? a - 1 - v : v;
        r[F][f] || (o[F][f] = i < p.length * 8 && (p[i >> 3] >> 7 - (i & 7) & 1) === 1, i++);
      }
  }
  let s = (d) => (c(d), o.map((v, f) => v.map((T, F) => T !== (!r[f][F] && Bs[d](F, f))))), u = s(0), h = Xo(u);
  for (let d = 1; d < 8; d++) {
    let v = s(d), f = Xo(v);
    f < h && ([u, h] = [v, f]);
  }
  return u;
}

// src/later/sheets.tsx
import { Fragment as mu, jsx as g, jsxs as P } from "./desk.js";
function nt({ title: e, wide: t, children: n }) {
  let a = Ut(null);
  tu(() => {
    let r = a.current, l = document.activeElement;
    return r.open || r.showModal(), () => l?.focus();
  }, []);
  let o = () => et.value = null;
  return g(
    "dialog",
    {
      ref: a,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: o,
      onClick: (r) => r.target === a.current && o(),
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
var ou = [
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
function lu() {
  let e = [...new Set(_n().map((t) => t.group))];
  return g(nt, { title: "All keys", wide: !0, children: P("div", { class: "help", children: [
    P("table", { children: [
      g("caption", { class: "spoken", children: "By hand" }),
      g("thead", { children: P("tr", { children: [
        g("th", { scope: "col", children: "What" }),
        g("th", { scope: "col", children: "Mouse" }),
        g("th", { scope: "col", children: "Keys, in the view" }),
        g("th", { scope: "col", children: "Fingers" })
      ] }) }),
      g("tbody", { children: ou.map(([t, n, a, o]) => P("tr", { children: [
        g("th", { scope: "row", children: t }),
        g("td", { children: n }),
        g("td", { children: a.replace("walking keys", nu.value) }),
        g("td", { children: o })
      ] }, t)) })
    ] }),
    P("div", { class: "columns", children: [
      e.map((t) => P("section", { children: [
        g("h3", { children: t }),
        g("dl", { children: _n().filter((n) => n.group === t && n.keys).map((n) => P(mu, { children: [
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
var Kt = tt(""), Je = tt(0);
function ru() {
  let e = Kt.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = _n().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: au(a.id), run: () => Zo(a.id) }));
  for (let { name: a, camera: o } of ft())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => Qs(o, a) });
  if (e.length)
    for (let [a, o] of Zs.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => Js("lamp", a) });
    }
  return n.slice(0, 60);
}
function iu() {
  let e = ru(), t = Math.min(Je.value, e.length - 1);
  jn(() => {
    Kt.value = "", Je.value = 0;
  }, []), jn(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (et.value = null, a.why ? Bt(a.why, "warn") : setTimeout(a.run, 0));
  };
  return P(nt, { title: "Command palette", children: [
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
        value: Kt.value,
        onInput: (a) => {
          Kt.value = a.currentTarget.value, Je.value = 0;
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
var Jo = tt([]);
Ys("links", (e) => Jo.value = e.links);
function su({ text: e }) {
  let t = Yo(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, r) => o.map((l, c) => l ? `M${c + 4} ${r + 4}h1v1h-1z` : "").join("")).join("");
  return P("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    g("rect", { width: n, height: n, fill: "#fff" }),
    g("path", { d: a, fill: "#000" })
  ] });
}
function uu() {
  let e = tt(null), t = Ut(e).current;
  return jn(() => {
    Gt({ do: "links", what: "list" });
  }, []), P(nt, { title: "Share by link", children: [
    g("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    g("ul", { class: "links", children: Jo.value.map((n) => P("li", { children: [
      g("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      g("code", { children: n.address }),
      P("span", { class: "buttons", children: [
        g("button", { onClick: () => {
          zs(n.address);
        }, children: "Copy" }),
        g("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        g("button", { onClick: () => Gt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && g(su, { text: n.address })
    ] }, n.id)) }),
    P("footer", { children: [
      g("button", { onClick: () => Gt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      g("button", { onClick: () => Gt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function cu() {
  let e = Ut(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    js({ do: "save", name: n }), et.value = null, Bt(`Saving the version “${n}”.`);
  };
  return P(nt, { title: "Save a version", children: [
    g("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    P("label", { class: "line", children: [
      g("span", { children: "Name" }),
      g("span", { class: "field", children: g("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    g("footer", { children: g("button", { onClick: t, children: "Save" }) })
  ] });
}
var te = tt(null);
function pu() {
  let e = eu.value?.head, t = Ut(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    te.value = 0;
    let [o, r] = [Number(n("width")), Number(n("height"))];
    _s("picture", { format: n("format"), width: o, height: r, batches: Number(n("batches")) }, (l) => {
      l.why ? (te.value = null, Bt(l.why, "warn")) : l.url ? (te.value = null, Bn(l.name, l.url), et.value = null) : te.value = l.progress ?? 0;
    }, (l) => {
      te.value = null, Bt(l, "warn");
    });
  };
  return P(nt, { title: "Save the picture", children: [
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
    te.value !== null && g("progress", { max: 1, value: te.value, "aria-label": "Rendering" }),
    P("footer", { children: [
      g("button", { onClick: () => Zo("command"), children: "Copy the command" }),
      g("button", { disabled: te.value !== null, onClick: a, children: te.value === null ? "Render and save" : te.value ? `${Xs(te.value * 100)} %` : "Rendering…" })
    ] })
  ] });
}
function du() {
  switch (et.value) {
    case "help":
      return g(lu, {});
    case "palette":
      return g(iu, {});
    case "share":
      return g(uu, {});
    case "save":
      return g(cu, {});
    case "picture":
      return g(pu, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import {
  act as hu,
  colorText as el,
  cost as gu,
  css as bu,
  Field as fu,
  groups as vu,
  hovered as _t,
  Icon as yu,
  lamps as ku,
  lumensOf as wu,
  penless as xu,
  pickRow as Mu,
  select as Su,
  selection as tl,
  switchOn as Cu,
  three as $u,
  typeGroupLevel as Lu,
  typeLevel as Pu
} from "./desk.js";
import { jsx as Y, jsxs as zn } from "./desk.js";
function Vu() {
  return zn("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    Y("span", {}),
    Y("span", { children: "Name" }),
    Y("span", { children: "Level" }),
    Y("span", { children: "lm" }),
    Y("span", { children: "White" })
  ] });
}
function Tu({ row: e, index: t, count: n }) {
  let a = e.kind === "lamp" ? ku.get(e.id) : void 0, o = e.kind === "group" ? vu.get(e.id) : void 0, r = a ?? o;
  if (!r) return null;
  let l = tl.value?.kind === e.kind && tl.value.ids.includes(e.id), c = wu(o?.lamps ?? [e.id]), p = xu.value, i = _t.value?.kind === e.kind && _t.value.id === e.id;
  return zn(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${l ? "selected" : ""} ${r.on ? "" : "off"} ${i ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => _t.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => _t.value = null,
      children: [
        Y("button", { class: "icon power", "aria-pressed": r.on, disabled: p !== null, title: p ?? void 0, "aria-label": `${r.name} on`, onClick: () => Cu(e, !r.on), children: Y(yu, { name: "power" }) }),
        Y("button", { class: "row-name", "aria-pressed": l, title: a ? gu(a) : void 0, onClick: (s) => Mu(s, e.kind, e.id), onDblClick: () => hu("frame"), children: Y("span", { children: r.name }) }),
        Y(
          fu,
          {
            label: `${r.name} level`,
            quantity: "level",
            value: r.level,
            flux: a?.flux,
            step: 0.01,
            disabled: p !== null,
            why: p,
            set: (s) => a ? Pu([e.id], s) : Lu(e.id, s)
          }
        ),
        Y("span", { class: "lumens", children: $u(c) }),
        a ? zn("button", { class: "tint", "aria-label": `${r.name} colour: ${el(a)}`, onClick: () => Su("lamp", e.id), children: [
          Y("i", { class: "swatch", style: { background: bu(a.swatch) } }),
          el(a)
        ] }) : Y("span", {})
      ]
    }
  );
}

// src/later/strip.tsx
import {
  act as Xn,
  command as rl,
  digits as Qn,
  fade as jt,
  Field as Eu,
  grids as nl,
  Icon as Ne,
  looks as al,
  luxText as be,
  maintenance as Iu,
  meters as ol,
  select as ll,
  selection as zt,
  signal as Au,
  storeLook as Ru
} from "./desk.js";
import { Fragment as Ou, jsx as M, jsxs as N } from "./desk.js";
var Yn = Au("looks");
function qu() {
  return N("section", { class: "looks", "aria-label": "Looks", children: [
    N("header", { children: [
      M("h2", { children: "Looks" }),
      M("button", { class: "tab", onClick: () => Yn.value = "meters", children: "Meters" }),
      M("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: Ru, children: M(Ne, { name: "plus" }) }),
      M("span", { class: "gap" }),
      N("label", { class: "tint", children: [
        "Fade",
        M(Eu, { label: "Cross-fade", quantity: "seconds", value: jt.value, step: 0.5, set: (e) => jt.value = Math.max(0, e(jt.value)) })
      ] })
    ] }),
    N("ul", { children: [
      al.all().map(([e, t], n) => N("li", { class: "look", children: [
        N("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => rl({ do: "look", id: e, what: "recall", seconds: jt.peek() }), children: [
          t.picture && M("img", { src: t.picture, alt: "" }),
          M("span", { children: t.name })
        ] }),
        M(Fu, { id: e, name: t.name })
      ] }, e)),
      !al.ids.value.length && M("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function Fu({ id: e, name: t }) {
  let n = `look-${e}`, a = (c) => {
    let p = c.getBoundingClientRect(), i = document.getElementById(n);
    i?.style.setProperty("left", `${Math.min(p.left, innerWidth - 296)}px`), i?.style.setProperty("bottom", `${innerHeight - p.top + 4}px`), i?.style.setProperty("top", "auto");
  }, o = { popovertarget: n }, r = () => document.getElementById(n)?.hidePopover(), l = (c, p = {}) => {
    r(), rl({ do: "look", id: e, what: c, ...p });
  };
  return N(Ou, { children: [
    M("button", { class: "icon more", ...o, "aria-label": `More of ${t}`, onPointerDown: (c) => a(c.currentTarget), onFocus: (c) => a(c.currentTarget), children: M(Ne, { name: "more" }) }),
    N("div", { id: n, popover: "auto", class: "menu", children: [
      N("label", { class: "line", children: [
        M("span", { children: "Name" }),
        M("span", { class: "field", children: M("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (c) => l("rename", { name: c.currentTarget.value }) }) })
      ] }),
      M("button", { class: "item", onClick: () => l("update"), children: M("span", { children: "Update to what is set now" }) }),
      M("button", { class: "item", onClick: () => l("recall", { seconds: 0 }), children: M("span", { children: "Recall at once" }) }),
      M("button", { class: "item", onClick: () => l("remove"), children: M("span", { children: "Remove" }) })
    ] })
  ] });
}
function Hu() {
  let e = Iu.value;
  return N("section", { class: "readings", "aria-label": "Meters and grids", children: [
    N("header", { children: [
      M("h2", { children: "Meters" }),
      M("button", { class: "tab", onClick: () => Yn.value = "looks", children: "Looks" }),
      M("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => Xn("meter-tool"), children: M(Ne, { name: "meter" }) }),
      M("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => Xn("grid"), children: M(Ne, { name: "grid" }) }),
      M("button", { onClick: () => Xn("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      M("button", { onClick: jo, title: "Save all figures as CSV", children: "CSV" }),
      M("span", { class: "gap" }),
      M("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${Qn(e, 2)} maintained` })
    ] }),
    N("ul", { children: [
      ol.all().map(([t, n]) => {
        let a = n.lux;
        return M("li", { children: N("button", { class: "reading", "aria-pressed": zt.value?.kind === "meter" && zt.value.ids.includes(t), onClick: () => ll("meter", t), children: [
          N("span", { class: "tint", children: [
            M(Ne, { name: "meter" }),
            n.name,
            " ",
            M(kn, { of: Mt(n) })
          ] }),
          M("strong", { class: wt(n) ? "unsettled" : "", children: a ? be(a[0] * e) : "…" }),
          N("small", { children: [
            a?.[1] != null ? `±${be(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind,
            n.target ? ` · wants ${be(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      nl.all().map(([t, n]) => {
        let a = n.target;
        return M("li", { children: N("button", { class: "reading", "aria-pressed": zt.value?.kind === "grid" && zt.value.ids.includes(t), onClick: () => ll("grid", t), children: [
          N("span", { class: "tint", children: [
            M(Ne, { name: "grid" }),
            n.name,
            " ",
            M(kn, { of: St(n) })
          ] }),
          M("strong", { class: xt(n) ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${be(n.mean * e)}${n.error == null ? "" : ` ±${be(n.error * e, !1)}`}` }),
          N("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : Qn(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : be(n.min * e, !1),
            " to",
            " ",
            n.max == null ? "…" : be(n.max * e, !1),
            a ? ` · wants ${be(a.lux)}, U₀ ${Qn(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !ol.ids.value.length && !nl.ids.value.length && M("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Nu() {
  return N("div", { class: "strip-parts", "data-tab": Yn.value, children: [
    M(qu, {}),
    M(Hu, {})
  ] });
}

// src/later/menus.tsx
import {
  camera as ul,
  digits as cl,
  display as Du,
  Field as Qt,
  go as pl,
  houseLights as Zn,
  Item as $e,
  Range as Wu,
  show as Jn,
  theme as il,
  walking as Gu
} from "./desk.js";
import { Fragment as Yt, jsx as C, jsxs as ne } from "./desk.js";
var Xt = Math.PI / 360;
function sl(e) {
  let t = ul.peek();
  t && pl({ ...t, fov: Math.max(3, Math.min(140, e)) });
}
function Ku() {
  let e = ul.value, t = ft();
  return ne(Yt, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((n) => C($e, { id: n }, n)),
    C("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((n) => C($e, { id: `preset-${n}` }, n)),
    C("hr", {}),
    t.length > 0 && C("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    t.map(({ name: n, camera: a }, o) => C("button", { class: "item", onClick: () => pl(a, n), children: C("span", { children: n }) }, o)),
    t.length > 0 && C("hr", {}),
    e && !e.height && ne(Yt, { children: [
      ne("label", { class: "line", children: [
        C("span", { children: "Angle" }),
        C(Qt, { label: "Vertical angle of view", quantity: "angle", value: e.fov, step: 1, set: (n) => sl(n(e.fov)) })
      ] }),
      ne("label", { class: "line", children: [
        C("span", { children: "Focal length" }),
        C(Qt, { label: "Focal length on 36 × 24 mm", quantity: "number", value: Math.round(120 / Math.tan(e.fov * Xt)) / 10, text: `${cl(12 / Math.tan(e.fov * Xt), 1)} mm`, step: 1, set: (n) => sl(Math.atan(12 / Math.max(2, n(12 / Math.tan(e.fov * Xt)))) / Xt) })
      ] }),
      C("hr", {})
    ] }),
    C($e, { id: "walking", label: Gu.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    C($e, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((n) => C($e, { id: `hands-${n}` }, n))
  ] });
}
var Bu = ["linear", "reinhard", "filmic"];
function Uu() {
  let e = Du.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return ne(Yt, { children: [
    ne("fieldset", { children: [
      C("legend", { children: "Tone curve" }),
      C("div", { class: "segments", children: Bu.map((n) => C("button", { "aria-pressed": e.tone === n, onClick: () => Jn({ tone: n }), children: n }, n)) })
    ] }),
    ne("fieldset", { children: [
      C("legend", { children: "White balance" }),
      ne("label", { class: "line", children: [
        C("span", { children: "White" }),
        C(Qt, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => Jn({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      ne("label", { class: "line", children: [
        C("span", { children: "Tint" }),
        C(Qt, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => Jn({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    C("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => C($e, { id: n }, n))
  ] });
}
function _u() {
  return ne(Yt, { children: [
    ne("label", { class: "line", children: [
      C("span", { children: "House lights" }),
      C(Wu, { label: "House lights", value: Zn.value, text: `${cl(Zn.value * 100)} %`, on: (e) => Zn.value = Math.max(0.3, e) })
    ] }),
    C("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => C("button", { "aria-pressed": il.value === e, onClick: () => il.value = e, children: e }, e)) }),
    C("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => C($e, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as Zt, cut as ju, digits as dl, edit as ml, go as zu, Icon as at, Range as Xu, setCut as Qu, signal as Yu, storeView as Zu, viewName as Ju, views as ec } from "./desk.js";
import { jsx as G, jsxs as ea } from "./desk.js";
var Jt = Yu(null);
function tc() {
  let e = ec.all();
  return ea("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    G("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => Zt("home"), children: G(at, { name: "home" }) }),
    G("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => Zt("frame"), children: G(at, { name: "frame" }) }),
    G("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => Zt("back"), children: G(at, { name: "back" }) }),
    G("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => Zt("forth"), children: G(at, { name: "forth" }) }),
    G("span", { class: "divide" }),
    e.map(([t, n], a) => Jt.value === t ? G("span", { class: "field", children: G(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (o) => o?.focus(),
        onBlur: (o) => {
          let r = o.currentTarget.value.trim();
          Jt.value = null, r && r !== n.name && ml(`Rename the view ${r}`, { views: { [t]: { ...n, name: r } } });
        },
        onKeyDown: (o) => {
          o.stopPropagation(), o.key === "Escape" && (o.currentTarget.value = n.name ?? ""), (o.key === "Enter" || o.key === "Escape") && o.currentTarget.blur();
        }
      }
    ) }, t) : ea(
      "button",
      {
        class: "saved-view",
        "aria-pressed": Ju.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click or F2 renames, Delete removes`,
        onClick: () => zu(n, n.name ?? "view"),
        onDblClick: () => Jt.value = t,
        onKeyDown: (o) => {
          o.key === "F2" && (Jt.value = t), o.key === "Delete" && (o.stopPropagation(), ml(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          G("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    G("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: Zu, children: G(at, { name: "plus" }) })
  ] });
}
function nc() {
  let e = ju.value;
  if (!e) return null;
  let t = e.height === null ? `${dl(e.value, 2)} m` : `at ${dl(e.height, 2)} m`;
  return ea("label", { class: "cut", "data-scroll": !0, children: [
    G("span", { children: "Cut" }),
    G(
      Xu,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => Qu(n * e.most)
      }
    ),
    G("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as ac, useRef as oc } from "./desk.js";
import { jsx as hl } from "./desk.js";
function lc() {
  let e = oc(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let r = a.getBoundingClientRect(), l = (i) => Math.max(-1, Math.min(1, i)), c = o ? 0 : l((n.clientX - r.left) / (r.width / 2) - 1), p = o ? 0 : l(1 - (n.clientY - r.top) / (r.height / 2));
    e.current?.style.setProperty("transform", `translate(${c * 28}px, ${-p * 28}px)`), ac(p, c);
  };
  return hl("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: hl("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as gl,
  closeWhat as bl,
  digits as rc,
  hovered as fl,
  Icon as ic,
  lamps as sc,
  luxText as fe,
  nameOf as uc,
  select as cc,
  useEffect as pc,
  useRef as dc,
  viewSize as mc,
  what as hc
} from "./desk.js";
import { jsx as B, jsxs as ae } from "./desk.js";
var Le = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], gc = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function bc() {
  let e = hc.value, t = dc(null);
  if (pc(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = mc.value, o = [...e.lamps].sort((u, h) => Le(h) - Le(u)), r = o.reduce((u, h) => u + Le(h), 0) || 1, l = o.slice(0, 9), c = r - l.reduce((u, h) => u + Le(h), 0), p = Math.max(8, Math.min(e.x + 12, n - 332)), i = Math.max(8, Math.min(e.y + 12, a - 150 - 35 * l.length)), s = e.lux ? `${fe(e.lux[0])} ±${fe(e.lux[1], !1)}` : "Measuring…";
  return ae(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${p}px`, top: `${i}px` },
      onKeyDown: (u) => {
        u.key === "Escape" && (u.stopPropagation(), bl(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        ae("header", { children: [
          B("strong", { class: e.done ? "" : "unsettled", children: s }),
          B("span", { class: "quiet", children: "what lights this" }),
          B("button", { class: "icon", "aria-label": "Close", onClick: bl, children: B(ic, { name: "close" }) })
        ] }),
        ae("ol", { children: [
          l.map((u) => B(
            "li",
            {
              onPointerEnter: () => fl.value = { kind: "lamp", id: u.id },
              onPointerLeave: () => fl.value = null,
              children: ae("button", { class: "row", onClick: () => cc("lamp", u.id), children: [
                B("span", { class: "name", children: uc("lamp", u.id) }),
                ae("span", { class: "figure", children: [
                  rc(100 * Le(u) / r, Le(u) / r < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                ae("span", { class: "figure lux", children: [
                  fe(Le(u)),
                  " ±",
                  fe(gc(u), !1)
                ] }),
                ae("span", { class: "shares", "aria-hidden": "true", children: [
                  B("i", { class: "direct", style: { width: `${100 * u.direct[0] / r}%` } }),
                  B("i", { class: "indirect", style: { width: `${100 * u.indirect[0] / r}%` } }),
                  B("i", { class: "caustic", style: { width: `${100 * u.caustic[0] / r}%` } })
                ] }),
                ae("span", { class: "spoken", children: [
                  "direct ",
                  fe(u.direct[0]),
                  ", indirect ",
                  fe(u.indirect[0]),
                  ", caustic",
                  " ",
                  fe(u.caustic[0])
                ] })
              ] })
            },
            u.id
          )),
          o.length > l.length && ae("li", { class: "quiet", children: [
            o.length - l.length === 1 ? "one more" : `${o.length - l.length} more together`,
            ": ",
            fe(c)
          ] }),
          !o.length && B("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        ae("footer", { children: [
          B("span", { class: "key direct", children: "direct" }),
          B("span", { class: "key indirect", children: "indirect" }),
          B("span", { class: "key caustic", children: "caustic" }),
          B("span", { class: "gap" }),
          gl.value.some((u) => sc.get(u)?.place?.direction) && B("button", { onClick: () => Be(gl.peek(), e.hit.point), children: "Aim here" }),
          B("button", { onClick: () => Ue(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Ir as Compare,
  nc as CutBar,
  hi as Gizmo,
  Cs as Inspector,
  qs as Legend,
  _u as PageItems,
  Uu as SeeingItems,
  Vu as SheetHead,
  Tu as SheetRow,
  du as Sheets,
  Nu as Strip,
  Ku as ViewItems,
  tc as ViewStrip,
  lc as WalkPad,
  bc as What
};
