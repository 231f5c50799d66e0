// src/later/actions.ts
import {
  adding as rl,
  asked as il,
  ask as sl,
  back as ul,
  candles as ea,
  chosenLamps as pe,
  clearSolo as cl,
  command as en,
  compareHeld as pl,
  copyText as ml,
  deselect as dl,
  each as nn,
  edit as an,
  exposeBy as ta,
  falseColor as hl,
  fine as na,
  forth as gl,
  frameSelection as bl,
  go as fl,
  goHome as vl,
  goInside as yl,
  goPreset as kl,
  handles as aa,
  hands as wl,
  here as xl,
  highlight as Ml,
  history as oa,
  lampMarks as la,
  lamps as dt,
  listing as ra,
  lookOnly as ia,
  panels as sa,
  PRESETS as Sl,
  register as Cl,
  say as mt,
  scene as $l,
  selection as ha,
  send as Ll,
  sheet as ze,
  show as Pl,
  soloSelection as Tl,
  spot as Xe,
  startTool as ke,
  stepSelection as ua,
  storeLook as El,
  storeView as Vl,
  theme as ca,
  things as pa,
  titleOf as ga,
  toggleFalse as Al,
  toggleWipe as Il,
  travel as ma,
  views as Rl,
  walking as tn,
  whyNot as Q
} from "./desk.js";

// src/later/tools.ts
import {
  add as Ce,
  adding as Xo,
  chosenLamps as jn,
  cross as Qo,
  distance as Yo,
  dot as Xt,
  edit as it,
  effect as Zo,
  free as Yn,
  grids as zn,
  lamps as $e,
  meters as Xn,
  normal as Qt,
  onTool as Jo,
  positionOf as el,
  say as st,
  scale as ce,
  select as tl,
  step as Yt,
  sub as ut,
  titleOf as ct,
  tool as ye,
  up as Zn
} from "./desk.js";
var Ke = null;
Zo(() => {
  ye.value !== "grid" && (Ke = null);
});
function nl(e) {
  if (!e) return st("There is nothing at that point.", "warn");
  switch (ye.peek()) {
    case "aim":
      Be(jn.peek(), e.point), ye.value = null;
      break;
    case "place":
      al(jn.peek(), e), ye.value = null;
      break;
    case "meter":
      Ue(e.point, e.normal), ye.value = null;
      break;
    case "grid":
      if (!Ke) {
        Ke = e;
        return;
      }
      ol(Ke.point, e.point), Ke = null, ye.value = null;
      break;
    case "add":
      ll(Xo.peek(), e), ye.value = null;
      break;
  }
}
Jo(nl);
function Be(e, t) {
  let n = {};
  for (let a of e) {
    let o = $e.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: Qt(ut(t, o.position)) } });
  }
  if (!Object.keys(n).length) return st("What is selected shines into all directions: it cannot be aimed.", "warn");
  it(`Aim ${ct(e)}`, { lamps: n });
}
function Zt(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let r = o.filter((l) => !n.has(l));
    r.length && (tl(t, r[r.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), 3e3);
}
function al(e, t) {
  let n = je(e), a = n.get(e[e.length - 1]);
  if (!a) return st("What is selected has no place.", "warn");
  let o = ($e.get(e[e.length - 1])?.place?.radius ?? 0) + 0.02;
  it(`Put ${ct(e)} on a surface`, _e(e, ut(Ce(t.point, ce(t.normal, o)), a), n));
}
function Ue(e, t) {
  let n = Yn(Xn);
  Zt(Xn, "meter"), it("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function Jt(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
function ol(e, t, n = { lux: 500, uniformity: 0.6 }) {
  let a = Zn.peek(), o = Math.abs(a[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], r = Qt(Qo(a, o)), l = ut(t, e), [i, u] = [Xt(l, o), Xt(l, r)];
  if (Math.abs(i) < 0.05 || Math.abs(u) < 0.05) return st("An area needs two corners that lie apart.", "warn");
  let s = Ce(e, Ce(ce(o, Math.min(i, 0)), ce(r, Math.min(u, 0))));
  [i, u] = [Math.abs(i), Math.abs(u)];
  let p = (g) => Math.max(1, Math.ceil(g / Jt(Math.max(i, u)))), c = Yn(zn);
  Zt(zn, "grid"), it("Lay a grid", {
    grids: {
      [c]: {
        name: `Area ${c + 1}`,
        corner: s,
        u: ce(o, i),
        v: ce(r, u),
        normal: a,
        columns: p(i),
        rows: p(u),
        target: n
      }
    }
  });
}
var Qn = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function ll(e, t) {
  let n = Zn.peek(), a = Xt(t.normal, n), o = a > 0.7 ? Ce(t.point, ce(n, 1.2)) : Ce(t.point, ce(t.normal, 0.15)), r = a > 0.7 || a < -0.7 ? ce(n, -1) : t.normal, l = { position: o };
  e !== "point" && e !== "sphere" && (l.direction = r), e === "spot" && Object.assign(l, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (l.radius = 0.15), e === "sphere" && (l.radius = 0.08);
  let i = $e.all().filter(([, u]) => u.own).length;
  Zt($e, "lamp"), Yt(`Add ${Qn[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${Qn[e] ?? e} ${i + 1}`, kind: e, flux: 800, place: l }
  });
}
function pt(e, t, n) {
  !e.length || t < 1 || Yt(`Copy ${ct(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function Jn(e) {
  e.length && Yt(`Remove ${ct(e)}`, { do: "remove", lamps: e });
}
function _e(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = $e.get(o)?.place, l = n.get(o);
    if (!l) continue;
    let i = Ce(l, t), u = r?.aim && Yo(r.aim, i) > 1e-6 ? { direction: Qt(ut(r.aim, i)) } : {};
    a[o] = { place: { position: i, ...u } };
  }
  return { lamps: a };
}
function je(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = $e.get(n), o = a && el(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/actions.ts
var ae = () => Q() ?? (pe.value.length ? null : "Select a lamp first.");
function ql() {
  let e = pe.peek(), t = !e.some((n) => dt.get(n)?.on);
  an(`${ga(e)} ${t ? "on" : "off"}`, { lamps: nn(e, { on: t }) });
}
function Fl() {
  let e = pe.peek(), t = !e.every((n) => dt.get(n)?.parked);
  an(`${t ? "Park" : "Unpark"} ${ga(e)}`, { lamps: nn(e, { parked: t }) });
}
function da(e) {
  let t = ha.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : pa.ids.peek().filter((a) => pa.get(a)?.hidden);
  if (!n.length) return mt(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  an(e ? "Hide things" : "Show hidden things", { things: nn(n, { hidden: e }) });
}
function Hl() {
  let e = pe.peek()[0], t = dt.get(e)?.place, n = xl();
  if (!t?.position || !t.direction || !n) return mt("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  fl({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function Nl() {
  sl("command", {}, (e) => {
    ml(e.text);
  });
}
var Ol = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Dl = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, Wl = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: bl },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: vl },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: yl },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: ul },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: gl },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Vl, why: Q },
  ...Sl.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Dl[e],
    keys: `Shift+${t + 1}`,
    run: () => kl(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      tn.value = tn.peek() === "walk" ? "fly" : "walk", mt(tn.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: Hl, why: ae },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => ua(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => ua(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => ke("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => ha.value = { kind: "lamp", ids: dt.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: dl },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: ql, why: ae },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Tl, why: () => pe.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: cl },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => Ml(!0), why: ae },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Fl, why: ae },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => ke("aim"), why: ae },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => Xe.peek() && Be(pe.peek(), Xe.peek().point), why: ae },
  { id: "place", group: "Lamps", label: "Put on a surface by pointing", keys: "Shift+N", run: () => ke("place"), why: ae },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => aa.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => aa.value = "turn" },
  ...Ol.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: Q,
    run: () => {
      rl.value = e, ke("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => pt(pe.peek(), 1, [0.5, 0, 0]), why: ae },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => Jn(pe.peek()), why: ae },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => da(!0), why: Q },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => da(!1), why: Q },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => en({ do: "undo" }), why: () => Q() ?? (oa.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => en({ do: "redo" }), why: () => Q() ?? (oa.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => ze.value = "save", why: Q },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => ze.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Nl },
  { id: "share", group: "Work", label: "Share by link", run: () => ze.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: Al },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = hl();
      Pl({ false_color: { ...il(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => ta(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => ta(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => Ll({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => pl(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: Il },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: Q, run: () => Xe.peek() ? Ue(Xe.peek().point, Xe.peek().normal) : ke("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => ke("meter"), why: Q },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => ke("grid"), why: Q },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => en({ do: "reach" }), why: Q },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => ea.value = ea.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: El, why: Q },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => mt("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => sa.value = !sa.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => ra.value = ra.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => ma.value = ma.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => la.value = !la.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => na.value = !na.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => ca.value = ca.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => ia.value = !ia.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => wl.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => ze.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => ze.value = "palette" }
];
Cl(Wl);
function ht() {
  return [...($l.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...Rl.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as Gl, comparing as Kl, digits as Bl, fitted as Ul, useEffect as _l, useRef as jl, viewSize as zl, wipeAt as on } from "./desk.js";
import { Fragment as Ql, jsx as ln, jsxs as Yl } from "./desk.js";
function Xl() {
  let e = Kl.value, t = Gl.value, n = jl(null);
  if (_l(() => {
    let s = n.current;
    !s || !t || (s.width = t.picture.width, s.height = t.picture.height, s.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = zl.value, o = on.value, r = Ul(t.picture.width, t.picture.height), l = Math.max(0, Math.min(1, (o * a - r.x) / (t.picture.width * r.scale))), i = (s) => {
    let p = s.currentTarget;
    if (s.stopPropagation(), s.type === "pointerdown") p.setPointerCapture(s.pointerId);
    else if (p.hasPointerCapture(s.pointerId)) {
      let c = p.parentElement.getBoundingClientRect();
      on.value = Math.max(0, Math.min(1, (s.clientX - c.left) / c.width));
    }
  }, u = (s) => {
    let p = { ArrowLeft: -0.02, ArrowRight: 0.02 }[s.key];
    p && (s.stopPropagation(), s.preventDefault(), on.value = Math.max(0, Math.min(1, o + p)));
  };
  return Yl(Ql, { children: [
    ln(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * l}% 0 0)` : "none" }
      }
    ),
    ln("span", { class: "tag left", children: "before" }),
    e === "wipe" && ln(
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
        "aria-valuetext": `${Bl(o * 100)} % before`,
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
  add as wa,
  chosenLamps as rr,
  computed as un,
  editor as ir,
  effect as sr,
  fitted as ur,
  Gesture as cr,
  handles as pr,
  lamps as bt,
  lookOnly as mr,
  middle as dr,
  nameOf as hr,
  normal as gr,
  pinhole as br,
  positionOf as Ma,
  role as fr,
  selection as vr,
  shown as yr,
  sub as kr,
  things as ft,
  titleOf as wr,
  tool as xr,
  turn as xa,
  useEffect as Mr,
  useRef as Sr,
  viewSize as Cr
} from "./desk.js";

// src/later/gizmo.ts
import { project as ba, ray as Zl } from "./desk.js";
import { across as Jl, add as oe, cross as er, distance as tr, dot as me, length as nr, normal as rn, scale as le, sub as Le } from "./desk.js";
var ar = "http://www.w3.org/2000/svg", sn = 84, we = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], gt = ["x", "y", "z"], fa = 0.1, or = 5 * Math.PI / 180, va = 48;
function ka(e, t) {
  let n = (d, b, k) => {
    let w = document.createElementNS(ar, d);
    return w.setAttribute("class", k), b.append(w), w;
  }, a = (d, b, k) => {
    let w = n("g", e, `handle ${d} ${gt[b] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), r = we.map((d, b) => a("ring", b, `ring-${gt[b]}`)), l = we.map((d, b) => a("plane", b, `plane-${gt[b]}`)), i = we.map((d, b) => a("arrow", b, `move-${gt[b]}`)), u = a("centre", -1, "move-view"), s = a("aim", -1, "aim"), p = n("text", e, "handle-text"), c = (d, b) => {
    let [k, w, T] = ba(d.hole, b);
    return T < 0.02 && !d.hole.parallel ? null : [d.fit.x + k * d.fit.scale, d.fit.y + w * d.fit.scale];
  }, g = (d, b) => {
    let k = ba(d.hole, b)[2];
    return sn / d.fit.scale * d.hole.pixel * (d.hole.parallel ? 1 : Math.max(k, 0.02));
  }, m = (d, b, k = !1) => {
    let w = b.filter((C) => C !== null), T = w.length < b.length || w.length < 2 ? "" : `M${w.map((C) => `${C[0].toFixed(1)} ${C[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    d.setAttribute("d", T);
  }, v = (d, b, k) => {
    d.setAttribute("d", b ? `M${b[0] - k} ${b[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, y = (d, b) => d.forEach((k) => k.group.classList.toggle("gone", !b));
  function V(d, b) {
    let k = d.position, w = c(b, k), T = g(b, k), C = d.mode === "move";
    y([...i, ...l, u], C && w !== null), y(r, !C && w !== null && d.turns);
    let j = d.aim ?? (d.direction ? oe(k, le(d.direction, 3 * T)) : null);
    if (y([s], j !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    we.forEach((D, U) => {
      let R = c(b, oe(k, le(D, T))), ot = R ? Math.hypot(R[0] - w[0], R[1] - w[1]) < 12 : !0;
      if (i[U].group.classList.toggle("gone", !C || ot), R && C) {
        let [ve, We] = [(R[0] - w[0]) / sn, (R[1] - w[1]) / sn], rt = Math.hypot(ve, We) || 1, [ue, Ge] = [ve / rt, We / rt], zt = [w[0] + 14 * ue, w[1] + 14 * Ge];
        m(i[U].hit, [zt, R]), i[U].seen.setAttribute("d", `M${zt[0].toFixed(1)} ${zt[1].toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}M${(R[0] - 9 * ue - 4.5 * Ge).toFixed(1)} ${(R[1] - 9 * Ge + 4.5 * ue).toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}L${(R[0] - 9 * ue + 4.5 * Ge).toFixed(1)} ${(R[1] - 9 * Ge - 4.5 * ue).toFixed(1)}`);
      }
      let [Oe, De] = [we[(U + 1) % 3], we[(U + 2) % 3]], Z = Math.abs(me(D, b.hole.parallel ? b.hole.forward : rn(Le(k, b.hole.eye)))) < 0.15;
      l[U].group.classList.toggle("gone", !C || Z);
      let lt = (ve, We) => c(b, oe(k, oe(le(Oe, ve * T), le(De, We * T)))), _n = [lt(0.3, 0.3), lt(0.5, 0.3), lt(0.5, 0.5), lt(0.3, 0.5)];
      if (m(l[U].hit, _n, !0), m(l[U].seen, _n, !0), !C) {
        let ve = Array.from({ length: va + 1 }, (We, rt) => {
          let ue = 2 * Math.PI * rt / va;
          return c(b, oe(k, oe(le(Oe, Math.cos(ue) * T), le(De, Math.sin(ue) * T))));
        });
        m(r[U].hit, ve), m(r[U].seen, ve);
      }
    }), v(u.hit, w, 13), v(u.seen, w, 7);
    let I = j && c(b, j);
    m(o, [w, I]), v(s.hit, I, 16), s.seen.setAttribute("d", I ? `M${I[0] - 8} ${I[1]}h16M${I[0]} ${I[1] - 8}v16M${I[0] - 5} ${I[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let B = t.effect(() => {
    let d = t.target.value, b = t.view.value;
    e.classList.toggle("empty", !d || !b), d && b && V(d, b);
  }), Kn = (d, b, k) => Zl(d.hole, (b.clientX - k.left - d.fit.x) / d.fit.scale, (b.clientY - k.top - d.fit.y) / d.fit.scale);
  function Ne(d, b, k) {
    d.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let T = t.view.peek();
      if (!T || !t.target.peek()) return;
      let C = e.getBoundingClientRect(), j = k(T), I = t.hold(b), D = Kn(T, w, C);
      j(D, !1, { ...I, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), d.setPointerCapture(w.pointerId), d.classList.add("held");
      let U = (Z) => {
        p.textContent = j(Kn(T, Z, C), Z.ctrlKey || Z.metaKey, I), p.setAttribute("x", String(Z.clientX - C.left + 16)), p.setAttribute("y", String(Z.clientY - C.top - 12));
      }, R = (Z) => {
        d.removeEventListener("pointermove", U), d.removeEventListener("pointerup", ot), d.removeEventListener("pointercancel", Oe), removeEventListener("keydown", De, !0), d.classList.remove("held"), p.textContent = "", Z ? I.end() : I.cancel();
      }, ot = () => R(!0), Oe = () => R(!1), De = (Z) => {
        Z.key === "Escape" && (Z.stopPropagation(), R(!1));
      };
      d.addEventListener("pointermove", U), d.addEventListener("pointerup", ot), d.addEventListener("pointercancel", Oe), addEventListener("keydown", De, !0);
    });
  }
  let _t = (d, b, k) => k ? Math.round(d / b) * b : d, jt = (d) => d.map((b) => b.toFixed(2)).join("  ") + " m";
  we.forEach((d, b) => {
    Ne(i[b].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (T, C, j) => {
        let I = lr(k, d, T);
        w ??= I;
        let D = le(d, _t(I - w, fa, C));
        return j.move(D), jt(D);
      };
    }), Ne(l[b].group, "move", () => Bn(d)), Ne(r[b].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (T, C, j) => {
        let I = ya(k.position, d, T), D = I && rn(Le(I, k.position), Jl(d));
        if (!D) return "";
        w.at ??= D;
        let U = Math.atan2(me(d, er(w.at, D)), me(w.at, D)), R = _t(U, or, C);
        return j.rotate(d, R), `${(R * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), Ne(u.group, "move", (d) => Bn(d.hole.forward)), Ne(s.group, "aim", (d) => {
    let b = t.target.peek(), k = b.aim ?? oe(b.position, le(b.direction, 3 * g(d, b.position))), w = Un(k, d.hole.forward);
    return (T, C, j) => {
      let I = w(T, C), D = oe(k, I);
      return tr(D, b.position) > 1e-3 && j.turn(rn(Le(D, b.position)), D), jt(D);
    };
  });
  function Bn(d) {
    let b = Un(t.target.peek().position, d);
    return (k, w, T) => {
      let C = b(k, w);
      return T.move(C), jt(C);
    };
  }
  function Un(d, b) {
    let k = null;
    return (w, T) => {
      let C = ya(d, b, w);
      return C ? (k ??= C, Le(C, k).map((j) => _t(j, fa, T))) : [0, 0, 0];
    };
  }
  return { stop: B };
}
function lr(e, t, n) {
  let a = Le(e, n.origin), o = me(t, n.direction), r = 1 - o * o;
  return r < 1e-6 ? 0 : (o * me(n.direction, a) - me(t, a)) / r;
}
function ya(e, t, n) {
  let a = me(t, n.direction);
  if (Math.abs(a) < 1e-4 * nr(t)) return null;
  let o = me(Le(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : oe(n.origin, le(n.direction, o));
}

// src/later/handles.tsx
import { jsx as Ar } from "./desk.js";
function $r([e, t, n, a], [o, r, l, i]) {
  return [
    a * o + e * i + t * l - n * r,
    a * r - e * l + t * i + n * o,
    a * l + e * r - t * o + n * i,
    a * i - e * o - t * r - n * l
  ];
}
var Lr = () => !mr.value && fr.value !== "watch" && ir.value.you && xr.value !== "aim", Sa = un(() => {
  let e = vr.value;
  if (!e || !Lr()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => ft.get(a) && !ft.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = rr.value.filter((n) => Ma(bt.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), Ca = (e) => {
  let t = ft.get(e);
  return t?.place?.position ?? (t?.box ? dr(t.box) : null);
}, Pr = un(() => {
  let e = Sa.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? Ma(bt.get(t)) : Ca(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? bt.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: pr.value
  };
}), Tr = un(() => {
  let e = yr.value;
  if (Cr.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: br(e.camera, t, n), fit: ur(t, n) };
}), Er = {
  effect: sr,
  target: Pr,
  view: Tr,
  hold(e) {
    let t = Sa.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? wr(n) : n.length === 1 ? hr("thing", n[0]) : `${n.length} things`, r = new cr(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), l = a === "lamps" ? je(n) : new Map(n.map((s) => [s, Ca(s)])), i = new Map(n.map((s) => [s, (a === "lamps" ? bt : ft).get(s)?.place])), u = (s) => {
      let p = n.map((c) => [c, s(c)]).filter(([, c]) => c);
      r.set({ [a]: Object.fromEntries(p.map(([c, g]) => [c, { place: g }])) });
    };
    return {
      move: (s) => a === "lamps" ? r.set(_e(n, s, l)) : u((p) => ({ position: wa(l.get(p), s) })),
      turn: (s, p) => u((c) => i.get(c)?.direction ? { direction: s, ...p ? { aim: p } : {} } : null),
      rotate: (s, p) => u((c) => {
        let g = i.get(c);
        if (g?.direction) {
          let y = gr(xa(g.direction, s, p)), V = g.aim && g.position ? xa(kr(g.aim, g.position), s, p) : null;
          return { direction: y, ...V ? { aim: wa(g.position, V) } : {} };
        }
        let m = Math.sin(p / 2), v = [s[0] * m, s[1] * m, s[2] * m, Math.cos(p / 2)];
        return { rotation: $r(v, g?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => r.end(),
      cancel: () => r.cancel()
    };
  }
};
function Vr() {
  let e = Sr(null);
  return Mr(() => ka(e.current, Er).stop, []), Ar("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as fo, deselect as qi, Icon as Pn, penless as Tn, selection as Fi, signal as Hi } from "./desk.js";

// src/later/measure.tsx
import {
  deselect as Pa,
  digits as Ee,
  edit as yt,
  grids as Nr,
  Icon as Ta,
  length as Ve,
  luxText as Ae,
  maintenance as cn,
  meters as Or,
  selection as Ea
} from "./desk.js";

// src/later/parts.tsx
import { Field as $a, Gesture as Ir, Range as Rr, stroke as qr, useRef as Fr } from "./desk.js";
import { jsx as re, jsxs as vt } from "./desk.js";
function q({ title: e, note: t, children: n }) {
  return vt("section", { class: "part", "aria-label": e, children: [
    vt("h3", { children: [
      e,
      t && re("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function G(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function A(e) {
  return vt("label", { class: "line", children: [
    re("span", { children: e.label }),
    re($a, { ...e, label: e.name ?? e.label })
  ] });
}
function Hr(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function J({ label: e, names: t, quantity: n, value: a, set: o, step: r, disabled: l }) {
  let i = t ?? ["X", "Y", "Z"];
  return vt("div", { class: "line", role: "group", "aria-label": e, children: [
    re("span", { children: e }),
    re("span", { class: "triple", children: i.map((u, s) => re(
      $a,
      {
        label: `${e} ${u}`,
        quantity: n,
        value: a[s],
        text: Hr(a[s], n),
        step: r,
        disabled: l,
        set: (p) => o(s, p)
      },
      u
    )) })
  ] });
}
function Pe({ label: e, name: t, value: n, text: a, patch: o, reset: r, notch: l, class: i, style: u, disabled: s }) {
  let p = Fr(null), c = (m) => () => {
    p.current?.[m](), p.current = null;
  }, g = (m) => p.current ? p.current.set(o(m)) : qr(e + t, t, o(m));
  return re(
    Rr,
    {
      label: e,
      value: n,
      text: a,
      notch: l,
      class: i,
      gradient: u,
      disabled: s,
      begin: () => p.current = new Ir(t),
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
import { Fragment as pn, jsx as P, jsxs as _ } from "./desk.js";
var Dr = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function Va() {
  let e = Ea.value?.ids[0], t = Or.get(e);
  if (!t) return P("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: r, ...l } = { ...t, ...o };
    yt(`${t.name}: ${a}`, { meters: { [e]: l } });
  };
  return _(pn, { children: [
    P("header", { class: "panel-head", children: P(Te, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    P("p", { class: "crumbs", children: t.lux?.[1] != null ? `${Ae(t.lux[0] * cn.value)} ±${Ae(t.lux[1] * cn.value, !1)}` : "measuring" }),
    P("div", { class: "scroll", children: _(q, { title: "Meter", children: [
      _("label", { class: "line", children: [
        P("span", { children: "Measures" }),
        P("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: Dr.map(([a, o]) => P("option", { value: a, children: o }, a)) })
      ] }),
      P(J, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: ie(t.point, a, o) }) }),
      P(A, { label: "Shall read", quantity: "lux", step: 50, value: t.target ?? 0, set: (a) => n("target", { target: a(t.target ?? 0) || null }) }),
      P(J, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: ie(t.normal, a, o) }) }),
      _("button", { class: "plain full", onClick: () => {
        Pa(), yt(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        P(Ta, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var La = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function Aa() {
  let e = Ea.value?.ids[0], t = Nr.get(e);
  if (!t) return P("p", { class: "quiet empty", children: "This grid is gone." });
  let n = cn.value, a = (i, u) => {
    let { name: s, corner: p, u: c, v: g, normal: m, columns: v, rows: y, target: V } = { ...t, ...u };
    yt(`${t.name}: ${i}`, { grids: { [e]: { name: s, corner: p, u: c, v: g, normal: m, columns: v, rows: y, target: V } } });
  }, o = () => {
    let i = Jt(Math.max(Ve(t.u), Ve(t.v)));
    a("standard spacing", { columns: Math.max(1, Math.ceil(Ve(t.u) / i)), rows: Math.max(1, Math.ceil(Ve(t.v) / i)) });
  }, r = (i, u, s) => _(pn, { children: [
    P("dt", { children: i }),
    P("dd", { children: u == null ? "…" : s(u) })
  ] }), l = t.target ?? { lux: 500, uniformity: 0.6 };
  return _(pn, { children: [
    P("header", { class: "panel-head", children: P(Te, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    _("p", { class: "crumbs", children: [
      Ee(Ve(t.u), 2),
      " × ",
      Ee(Ve(t.v), 2),
      " m, ",
      Ee(t.columns * t.rows),
      " points"
    ] }),
    _("div", { class: "scroll", children: [
      P(q, { title: "Figures", note: n === 1 ? "new" : `× ${Ee(n, 2)}`, children: _("dl", { class: "figures", children: [
        r("Ē", t.mean, (i) => Ae(i * n)),
        r("E min", t.min, (i) => Ae(i * n)),
        r("E max", t.max, (i) => Ae(i * n)),
        r("U₀ = min / mean", t.uniformity, (i) => Ee(i, 2)),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => Ee(i, 2)),
        r("± of Ē", t.error, (i) => Ae(i * n))
      ] }) }),
      _(q, { title: "Target", children: [
        _("label", { class: "line", children: [
          P("span", { children: "Class" }),
          _("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let u = La[Number(i.currentTarget.value)];
            a("target", { target: u ? { lux: u[1], uniformity: u[2] } : null });
          }, children: [
            P("option", { value: "", children: t.target ? "choose…" : "none" }),
            La.map(([i, u, s], p) => _("option", { value: p, children: [
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
      _(q, { title: "Area", children: [
        P(J, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, u) => a("move", { corner: ie(t.corner, i, u) }) }),
        P(A, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        P(A, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        P("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: o, children: "Spacing of the standard" }),
        _("button", { class: "plain full", onClick: () => {
          Pa(), yt(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          P(Ta, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as he,
  chosenLamps as ei,
  dot as bn,
  edit as xt,
  format as Ka,
  groups as Mt,
  handles as kt,
  Icon as Re,
  lamps as kn,
  layers as ti,
  lumensOf as ni,
  normal as Ba,
  output as ai,
  percent as yn,
  positionOf as Ha,
  selection as fn,
  signal as Ua,
  spot as oi,
  sub as Na,
  titleOf as wn,
  tool as _a,
  toLevel as Oa,
  toTravel as li,
  typeLevel as vn,
  up as ri,
  Fade as ii,
  Field as si,
  wantLevel as Da,
  compass as ja,
  add as St,
  scale as qe,
  length as ui,
  Range as ci,
  strokeLevel as Wa,
  useRef as pi
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as Br,
  digits as Ra,
  edit as Ur,
  fromHex as _r,
  hex as jr,
  lamps as qa,
  mired as xe,
  titleOf as zr
} from "./desk.js";

// src/later/white.ts
import { css as Wr, mired as mn } from "./desk.js";
function Gr(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((r) => Math.max(0, r));
}
function Kr(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function Ia(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, r) => {
    let l = mn(e) + (mn(t) - mn(e)) * r / (n - 1);
    return Wr(Gr(...Kr(1e6 / l)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as hn, jsx as N, jsxs as de } from "./desk.js";
var Qe = 1800, gn = 1e4, Xr = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], Qr = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], Yr = Ia(Qe, gn), dn = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(qa.get(n).color) }]))
}), Zr = (e) => {
  let t = 1e6 / (xe(Qe) + (xe(gn) - xe(Qe)) * e);
  return Math.round(t / 10) * 10;
}, Jr = (e) => (xe(e) - xe(Qe)) / (xe(gn) - xe(Qe));
function Fa() {
  let e = Br.value, t = e.map((l) => qa.get(l)?.color).filter((l) => l !== void 0);
  if (!t.length) return null;
  let n = G(t.map((l) => l.mode)), a = t[0], o = zr(e), r = (l, i) => Ur(`${o}: ${l}`, dn(e, i));
  return de(hn, { children: [
    de("div", { class: "line", children: [
      N("span", { children: "Colour" }),
      N("div", { class: "segments", role: "group", "aria-label": "Colour by", children: Qr.map(([l, i]) => N("button", { "aria-pressed": n === l, onClick: () => r(`colour by ${i}`, () => ({ mode: l })), children: i }, l)) })
    ] }),
    n === "kelvin" && de(hn, { children: [
      de("div", { class: "line slide", children: [
        N("span", { children: "White" }),
        N(
          Pe,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: Yr,
            value: Jr(a.kelvin),
            text: `${Ra(a.kelvin)} kelvin`,
            patch: (l) => dn(e, () => ({ mode: "kelvin", kelvin: Zr(l) }))
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
      N("div", { class: "whites", role: "group", "aria-label": "Whites", children: Xr.map(([l, i]) => N("button", { title: i, "aria-label": `${l} kelvin, ${i}`, onClick: () => r(`${l} K`, () => ({ mode: "kelvin", kelvin: l })), children: l }, l)) }),
      de("div", { class: "line slide", children: [
        N("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        N(
          Pe,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${Ra(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (l) => dn(e, () => ({ tint: Math.round((l * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      N(A, { label: "", name: "Tint, typed", quantity: "number", value: G(t.map((l) => l.tint)), step: 1, set: (l) => r("tint", (i) => ({ tint: Math.max(-50, Math.min(50, l(i.tint))) })) })
    ] }),
    n === "rgb" && de(hn, { children: [
      de("label", { class: "line", children: [
        N("span", { children: "Colour" }),
        N("input", { type: "color", class: "pick", "aria-label": "Colour", value: jr(a.rgb), onChange: (l) => r("colour", () => ({ mode: "rgb", rgb: _r(l.currentTarget.value) })) })
      ] }),
      N(
        J,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (l, i) => r("colour", (u) => ({ rgb: u.rgb.map((s, p) => p === l ? Math.max(0, i(s)) : s) }))
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
          set: (i) => r("chromaticity", (u) => ({ xy: u.xy.map((s, p) => p === l ? Math.max(0.01, Math.min(0.9, i(s))) : s) }))
        },
        l
      )) })
    ] }),
    n === null && N("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as xn, jsx as f, jsxs as O } from "./desk.js";
var Ie = Ua(1), wt = Ua([1, 0, 0]), mi = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], Ct = 180 / Math.PI;
function Ga(e, t) {
  let { right: n, ahead: a } = ja(t), o = -bn(e, t);
  return [Math.atan2(bn(e, n), bn(e, a)) * Ct, Math.asin(Math.max(-1, Math.min(1, o))) * Ct];
}
function di(e, t, n) {
  let { right: a, ahead: o } = ja(n), [r, l] = [e / Ct, t / Ct], i = St(qe(a, Math.sin(r)), qe(o, Math.cos(r)));
  return Ba(St(qe(i, Math.cos(l)), qe(n, -Math.sin(l))));
}
function hi({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction);
  return O("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    O("button", { "aria-pressed": _a.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => he("aim"), children: [
      f(Re, { name: "aim" }),
      "Aim"
    ] }),
    f("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => he("solo"), children: f(Re, { name: "solo" }) }),
    f("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => he("from-lamp"), children: f(Re, { name: "eye" }) }),
    f("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => he("frame"), children: f(Re, { name: "frame" }) }),
    f("span", { class: "gap" }),
    f("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => he("park"), children: "Park" }),
    f("button", { class: "icon", "aria-label": `Remove ${wn(e)}`, title: "Remove (Del)", onClick: () => he("remove"), children: f(Re, { name: "bin" }) })
  ] });
}
function gi({ ids: e, all: t }) {
  let n = G(t.map((l) => l.level)), a = ni(e), o = t.every((l) => l.free), r = e[e.length - 1];
  return O(q, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    O("div", { class: "line slide", children: [
      f("span", { children: "Level" }),
      f(bi, { id: r })
    ] }),
    O("label", { class: "line", children: [
      f("span", {}),
      f(
        si,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: G(t.map((l) => l.flux)) ?? void 0,
          step: 0.01,
          set: (l) => vn(e, l),
          open: Da.value,
          opened: () => Da.value = "",
          id: "level"
        }
      )
    ] }),
    f(
      A,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (l) => vn(e, (i, u) => l(i * u) / u)
      }
    ),
    O("div", { class: "line", children: [
      f("span", { children: "Stops" }),
      f("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: mi.map(([l, i]) => f("button", { "aria-label": `${i} stop`, onClick: () => vn(e, (u) => Math.min(1e3, u * 2 ** l)), children: i }, i)) })
    ] }),
    O("p", { class: "sum", children: [
      Ka(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (Mt.get(t[0].group)?.level ?? 1) !== 1 && ` (${yn(t[0].level)} % × ${yn(Mt.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    f(Fa, {})
  ] });
}
function bi({ id: e }) {
  let t = pi(null), n = kn.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (r) => () => {
    t.current?.[r](), t.current = null;
  };
  return f(
    ci,
    {
      label: "Level",
      value: li(n.level),
      text: `${yn(n.level)} %, ${Ka(n.flux * ai(n), "flux")}`,
      begin: () => t.current = new ii(a),
      on: (r) => t.current ? t.current.to(Oa(r)) : Wa(a, Oa(r)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => Wa(a, 1)
    }
  );
}
function Ye(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = kn.get(o), l = n(r.place ?? {}, r);
    l && (a[o] = { place: l });
  }
  Object.keys(a).length && xt(`${wn(e)}: ${t}`, { lamps: a });
}
function fi({ ids: e, all: t }) {
  let n = (o) => G(t.map((r) => r.place?.[o] ?? null)), a = (o) => t.some((r) => r.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : O(q, { title: "Beam", note: "re-trace", children: [
    a("outer") && O(xn, { children: [
      f(A, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => Ye(e, "beam", (r) => r.outer == null ? null : { inner: Math.max(0.1, Math.min(r.outer, o(r.inner ?? r.outer))) }) }),
      f(A, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => Ye(e, "beam", (r) => {
        if (r.outer == null) return null;
        let l = Math.max(0.2, Math.min(179, o(r.outer)));
        return { outer: l, inner: Math.min(r.inner ?? l, l) };
      }) })
    ] }),
    a("radius") && f(A, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => Ye(e, "radius", (r) => r.radius == null ? null : { radius: Math.max(1e-3, o(r.radius)) }) })
  ] });
}
function vi({ ids: e, all: t }) {
  let n = t.filter((c) => Ha(c) !== null);
  if (!n.length) return null;
  let a = n.map((c) => Ha(c)), o = (c, g) => G(g.map((m) => Math.round(m[c] * 1e4) / 1e4)), r = t.filter((c) => c.place?.direction), l = ri.value, i = r.map((c) => Ga(c.place?.direction, l).map((g) => Math.round(g * 10) / 10)), u = t.map((c) => c.place?.aim).filter((c) => !!c), s = (c, g) => {
    let m = je(e), v = {};
    for (let [y, V] of m) {
      let B = [0, 0, 0];
      B[c] = g(V[c]) - V[c], Object.assign(v, _e([y], B, m).lamps);
    }
    xt(`Move ${wn(e)}`, { lamps: v });
  }, p = (c, g) => Ye(e, c ? "tilt" : "pan", (m) => {
    if (!m.direction) return null;
    let v = Ga(m.direction, l);
    v[c] = g(v[c]);
    let y = di(v[0], Math.max(-90, Math.min(90, v[1])), l), V = m.aim && m.position ? ui(Na(m.aim, m.position)) : 0;
    return { direction: y, ...V && m.position ? { aim: St(m.position, qe(y, V)) } : {} };
  });
  return O(q, { title: "Place", note: "re-trace", children: [
    f(J, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => o(c, a)), set: s }),
    r.length > 0 && O(xn, { children: [
      f(A, { label: "Pan", quantity: "angle", step: 1, value: G(i.map((c) => c[0])), set: (c) => p(0, c) }),
      f(A, { label: "Tilt", quantity: "angle", step: 1, value: G(i.map((c) => c[1])), set: (c) => p(1, c) }),
      f(
        J,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: u.length ? [0, 1, 2].map((c) => o(c, u)) : [NaN, NaN, NaN],
          set: (c, g) => Ye(e, "aim", (m) => {
            if (!m.direction || !m.position) return null;
            let v = ie(m.aim ?? St(m.position, qe(m.direction, 2)), c, g);
            return { aim: v, direction: Ba(Na(v, m.position)) };
          })
        }
      )
    ] }),
    O("div", { class: "line", children: [
      f("span", { children: "Handles" }),
      O("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        f("button", { "aria-pressed": kt.value === "move", onClick: () => kt.value = "move", children: "Move" }),
        f("button", { "aria-pressed": kt.value === "turn", onClick: () => kt.value = "turn", children: "Turn" })
      ] })
    ] }),
    f("button", { class: "plain full", "aria-pressed": _a.value === "place", onClick: () => he("place"), children: "Put on a surface by pointing" }),
    r.length > 0 && oi.value && f("button", { class: "plain full", onClick: () => he("aim-here"), children: "Aim at the last point" })
  ] });
}
function yi({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : O(q, { title: "Copies along a line", children: [
    f(A, { label: "How many", quantity: "number", step: 1, value: Ie.value, set: (n) => Ie.value = Math.max(1, Math.min(100, Math.round(n(Ie.value)))) }),
    f(J, { label: "Step", quantity: "length", step: 0.05, value: wt.value, set: (n, a) => wt.value = ie(wt.value, n, a) }),
    O("button", { class: "plain full", onClick: () => pt(e, Ie.value, wt.value), children: [
      f(Re, { name: "copy" }),
      Ie.value === 1 ? "One copy" : `${Ie.value} copies`
    ] })
  ] });
}
function za() {
  let e = ei.value, t = e.map((l) => kn.get(l)).filter((l) => !!l);
  if (!t.length) return f("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && Mt.get(n.group), o = fn.value?.kind === "group" ? Mt.get(fn.value.ids[0]) : void 0, r = n?.layer != null ? ti.value[n.layer] : void 0;
  return O(xn, { children: [
    f("header", { class: "panel-head", children: n ? f(Te, { label: "Name of the lamp", value: n.name, set: (l) => xt(`Rename ${n.name}`, { lamps: { [e[0]]: { name: l } } }) }) : o ? f(Te, { label: "Name of the group", value: o.name, set: (l) => xt(`Rename ${o.name}`, { groups: { [fn.value.ids[0]]: { name: l } } }) }) : O("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    f("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((l) => l.on).length} of ${t.length} on` }),
    O("div", { class: "scroll", children: [
      f(hi, { ids: e, all: t }),
      f(gi, { ids: e, all: t }),
      f(q, { title: "Photometry", children: f("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      f(fi, { ids: e, all: t }),
      f(vi, { ids: e, all: t }),
      f(yi, { ids: e, all: t }),
      f("p", { class: "cost", children: t.every((l) => l.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as Mn,
  candles as $t,
  command as ki,
  digits as Pt,
  edit as Xa,
  Field as wi,
  filterOf as Ja,
  go as xi,
  history as Mi,
  hovered as Qa,
  Icon as Tt,
  layers as Si,
  lookOnly as Ya,
  maintenance as Fe,
  materials as Ci,
  percent as $i,
  scene as Li,
  select as eo,
  signal as Pi,
  singleKeys as Za,
  sub as Ti,
  things as Ei,
  travel as Lt,
  Virtual as to
} from "./desk.js";
import { Fragment as Vi, jsx as M, jsxs as E } from "./desk.js";
function no() {
  let e = Li.value;
  if (!e) return null;
  let t = Ti(e.bounds[1], e.bounds[0]);
  return E(Vi, { children: [
    E(q, { title: "Room", children: [
      E("p", { children: [
        t.map((n) => Pt(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${Pt(e.triangles)} triangles` : ""
      ] }),
      M("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && M("ul", { class: "buttons", children: e.cameras.map((n, a) => M("li", { children: M("button", { onClick: () => xi(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && E("details", { children: [
        E("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        M("ul", { class: "remarks", children: e.warnings.map((n) => M("li", { children: n }, n)) })
      ] })
    ] }),
    E(q, { title: "Figures", children: [
      E("label", { class: "line", children: [
        M("span", { children: "Maintenance" }),
        M(wi, { label: "Maintenance factor", quantity: "share", value: Fe.value, step: 0.05, set: (n) => Fe.value = Math.max(0.1, Math.min(1, n(Fe.value))) })
      ] }),
      E("p", { class: "quiet", children: [
        Fe.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Fe.value === 1 && M("button", { class: "plain", onClick: () => Fe.value = 0.8, children: "0.80" })
      ] }),
      E("div", { class: "line", children: [
        M("span", { children: "Unit" }),
        E("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          M("button", { "aria-pressed": $t.value === "lx", onClick: () => $t.value = "lx", children: "lx, cd/m²" }),
          M("button", { "aria-pressed": $t.value === "fc", onClick: () => $t.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    M(q, { title: "Layers of light", children: M("ul", { class: "layers", children: Si.value.map((n, a) => E("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      M("i", { class: "dot", "aria-hidden": "true" }),
      M("span", { children: n.name || `layer ${a + 1}` }),
      M("small", { children: n.held ? "held" : $i(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    E(q, { title: "Hands", children: [
      E("div", { class: "line", children: [
        M("span", { children: "Faders" }),
        E("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          M("button", { "aria-pressed": Lt.value === "square", onClick: () => Lt.value = "square", children: "Square law" }),
          M("button", { "aria-pressed": Lt.value === "linear", onClick: () => Lt.value = "linear", children: "Even" })
        ] })
      ] }),
      E("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: Za.value, onChange: (n) => Za.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      E("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: Ya.value, onChange: (n) => Ya.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var Et = Pi("");
function ao({ label: e }) {
  return M("span", { class: "field filter", children: M("input", { type: "text", "aria-label": e, placeholder: "Filter", value: Et.value, onInput: (t) => Et.value = t.currentTarget.value }) });
}
function oo() {
  let e = Ja(Ei, Et.value);
  return E("div", { class: "listing", children: [
    M(ao, { label: "Filter things" }),
    M(
      to,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => Qa.value = { kind: "thing", id: n }, onPointerLeave: () => Qa.value = null, children: [
            M("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => Xa(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: M(Tt, { name: a.hidden ? "eye-off" : "eye" }) }),
            M("button", { class: "row-name", onClick: () => eo("thing", n), children: M("span", { children: a.name }) }),
            M("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => Xa(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: M(Tt, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function lo() {
  let e = Ja(Ci, Et.value);
  return E("div", { class: "listing", children: [
    M(ao, { label: "Filter materials" }),
    M(
      to,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row material", role: "listitem", children: [
            M("button", { class: "row-name", onClick: () => eo("material", n), children: M("span", { children: a.name }) }),
            E("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${Pt(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function ro() {
  let e = Mi.value;
  return E(q, { title: "History", children: [
    E("p", { children: [
      e.steps === 1 ? "One step" : `${Pt(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => Mn("undo"), children: [
      M(Tt, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => Mn("redo"), children: [
      M(Tt, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    M("button", { class: "plain full", onClick: () => Mn("save"), children: "Save a version with a name…" }),
    M("button", { class: "plain full", onClick: () => ki({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as Sn,
  edit as co,
  fromHex as Ai,
  hex as Ii,
  Icon as io,
  materials as po,
  middle as so,
  select as mo,
  selection as ho,
  things as Cn
} from "./desk.js";
import { Fragment as Ln, jsx as $, jsxs as z } from "./desk.js";
var $n = 180 / Math.PI;
function uo(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * $n : 0;
}
function Ri(e, t) {
  let n = [0, 0, 0, Math.cos(t / $n / 2)];
  return n[e] = Math.sin(t / $n / 2), n;
}
function go() {
  let e = (ho.value?.ids ?? []).filter((u) => Cn.get(u)), t = e.map((u) => Cn.get(u));
  if (!t.length) return $("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((u) => u.locked), r = (u, s) => co(`${a}: ${u}`, { things: Object.fromEntries(e.map((p, c) => [p, s(t[c])])) }), l = t.map((u) => u.place?.position ?? (u.box ? so(u.box) : [0, 0, 0])), i = n.box ? [0, 1, 2].map((u) => n.box[1][u] - n.box[0][u]) : null;
  return z(Ln, { children: [
    $("header", { class: "panel-head", children: $("h2", { children: a }) }),
    i && z("p", { class: "crumbs", children: [
      i.map((u) => Sn(u, 2)).join(" × "),
      " m"
    ] }),
    z("div", { class: "scroll", children: [
      z("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        z("button", { "aria-pressed": t.every((u) => u.hidden), onClick: () => r(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          $(io, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        z("button", { "aria-pressed": o, onClick: () => r(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          $(io, { name: o ? "lock" : "unlock" }),
          o ? "Locked" : "Lock"
        ] })
      ] }),
      z(q, { title: "Place", note: "re-trace", children: [
        o && $("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        $(
          J,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: o,
            value: [0, 1, 2].map((u) => G(l.map((s) => Math.round(s[u] * 1e4) / 1e4))),
            set: (u, s) => r("move", (p) => ({ place: { position: ie(p.place?.position ?? so(p.box), u, s) } }))
          }
        ),
        [0, 1, 2].map((u) => $(
          A,
          {
            label: `Turn ${"XYZ"[u]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: G(t.map((s) => Math.round(uo(s.place?.rotation, u) * 10) / 10)),
            set: (s) => r("turn", (p) => ({ place: { rotation: Ri(u, s(uo(p.place?.rotation, u))) } }))
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
      $(q, { title: "Materials", children: $("ul", { class: "buttons", children: n.materials.map((u) => $("li", { children: $("button", { onClick: () => mo("material", u), children: po.get(u)?.name ?? `material ${u}` }) }, u)) }) })
    ] })
  ] });
}
function bo() {
  let e = ho.value?.ids[0], t = po.get(e);
  if (!t) return $("p", { class: "quiet empty", children: "This material is gone." });
  let n = (s, p) => co(`${t.name}: ${s}`, { materials: { [e]: p } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], l = ((s) => 0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2])(o), i = (s) => o.map((p) => Math.max(0, Math.min(1, l > 1e-4 ? p / l * s : s))), u = (s, p) => t[p] != null && z(Ln, { children: [
    z("div", { class: "line slide", children: [
      $("span", { children: s }),
      $(Pe, { label: s, name: `${t.name}: ${s.toLowerCase()}`, value: t[p], text: Sn(t[p], 2), patch: (c) => ({ materials: { [e]: { [p]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    $(A, { label: "", name: `${s}, typed`, quantity: "share", step: 0.01, value: t[p], set: (c) => n(s.toLowerCase(), { [p]: Math.max(0, Math.min(1, c(t[p]))) }) })
  ] });
  return z(Ln, { children: [
    $("header", { class: "panel-head", children: $("h2", { children: t.name }) }),
    $("p", { class: "crumbs", children: t.kind }),
    z("div", { class: "scroll", children: [
      z(q, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        z("div", { class: "line slide", children: [
          $("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          $(Pe, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: l, text: Sn(l, 2), patch: (s) => ({ materials: { [e]: { [a]: i(Math.min(0.95, s)) } } }) })
        ] }),
        $(A, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(l * 1e3) / 1e3, set: (s) => n("reflectance", { [a]: i(Math.min(0.98, s(l))) }) }),
        z("label", { class: "line", children: [
          $("span", { children: "Colour" }),
          $("input", { type: "color", class: "pick", "aria-label": "Colour", value: Ii(o), onChange: (s) => n("colour", { [a]: Ai(s.currentTarget.value) }) })
        ] }),
        u("Roughness", "roughness"),
        u("Gloss", "specular")
      ] }),
      $(q, { title: "On", children: $("ul", { class: "buttons", children: Cn.all().filter(([, s]) => s.materials.includes(e)).slice(0, 40).map(([s, p]) => $("li", { children: $("button", { onClick: () => mo("thing", s), children: p.name }) }, s)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as vo, jsx as F, jsxs as Vt } from "./desk.js";
var Ze = ["Scene", "Things", "Materials", "History"], ge = Hi("Scene");
function Ni() {
  let e = { Scene: no, Things: oo, Materials: lo, History: ro }[ge.value];
  return Vt(vo, { children: [
    F("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), ge.value = Ze[(Ze.indexOf(ge.value) + a + Ze.length) % Ze.length], document.getElementById(`tab-${ge.value}`)?.focus());
    }, children: Ze.map((n) => F("button", { id: `tab-${n}`, role: "tab", "aria-selected": ge.value === n, "aria-controls": "tab-panel", tabIndex: ge.value === n ? 0 : -1, onClick: () => ge.value = n, children: n }, n)) }),
    F("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${ge.value}`, tabIndex: 0, children: F(e, {}) })
  ] });
}
function Oi() {
  let e = Fi.value;
  return e ? Vt(vo, { children: [
    Vt("nav", { class: "chooser", "aria-label": "Selection", children: [
      F("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => fo("previous"), children: F(Pn, { name: "back" }) }),
      F("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => fo("next"), children: F(Pn, { name: "forth" }) }),
      F("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      F("span", { class: "gap" }),
      F("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: qi, children: F(Pn, { name: "close" }) })
    ] }),
    Tn.value && F("p", { class: "penless", children: Tn.value }),
    Vt("fieldset", { class: "editing", disabled: Tn.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && F(za, {}),
      e.kind === "thing" && F(go, {}),
      e.kind === "material" && F(bo, {}),
      e.kind === "meter" && F(Va, {}),
      e.kind === "grid" && F(Aa, {})
    ] })
  ] }) : F(Ni, {});
}

// src/later/legend.tsx
import { asked as Di, candles as Wi, display as Gi, Field as Ki, show as Bi, three as Ui, useRef as _i } from "./desk.js";
import { jsx as X, jsxs as At } from "./desk.js";
var En = [1, 2, 5];
function ji(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, r = 10 ** Math.floor(Math.log10(o)), l = r * (En.find((i) => i * r >= o) ?? 10);
    for (let i = Math.ceil(e / l) * l; i <= t * 1.0001; i += l) a.push(i);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let r of En) {
      let l = r * 10 ** o;
      l >= e * 0.999 && l <= t * 1.001 && a.push(l);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function zi(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var se = (e, t) => {
  let n = Di({ ...e, ...t });
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && Bi({ false_color: n });
};
function yo(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return En[a] * 10 ** ((n - a) / 3);
}
function Xi() {
  let e = Gi.value.false_color, t = _i(null);
  if (!e) return null;
  let n = Wi.value === "fc", a = e.quantity === "illuminance", o = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", r = n ? a ? 1 / 10.7639 : 0.2919 : 1, l = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, i = e.ticks ?? ji(e.low, e.high, e.scale).map((p) => [p, zi(p, e)]), u = (p) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: p, from: e[p] };
    },
    onPointerMove: (c) => {
      let g = t.current;
      g?.end === p && se(e, { [p]: yo(g.from, Math.round((g.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let g = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      g && (c.preventDefault(), c.stopPropagation(), se(e, { [p]: yo(e[p], g) }));
    }
  }), s = ({ end: p }) => At("div", { class: "end", children: [
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
        "aria-valuetext": `${Ui(e[p] * r)} ${o}`,
        ...u(p)
      }
    ),
    X(
      Ki,
      {
        label: p === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[p] * r).toPrecision(3)),
        set: (c) => se(e, { [p]: c(e[p] * r) / r })
      }
    )
  ] });
  return At("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    At("header", { children: [
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
    X(s, { end: "high" }),
    X("div", { class: "scale", style: { background: l }, children: i.map(([p, c]) => X("span", { style: { bottom: `${100 * c}%` }, children: String(Number((p * r).toPrecision(2))) }, p)) }),
    X(s, { end: "low" }),
    At("footer", { children: [
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
  allActions as In,
  act as Po,
  ask as ls,
  command as rs,
  copyText as is,
  digits as ss,
  go as us,
  hear as cs,
  lamps as ps,
  say as Ft,
  select as ms,
  send as Rt,
  sheet as et,
  shown as ds,
  signal as tt,
  useEffect as Rn,
  useLayoutEffect as hs,
  useRef as Ht,
  walkNames as gs,
  whyNotTo as bs
} from "./desk.js";

// src/later/csv.ts
import { add as ko, grids as Qi, maintenance as Yi, meters as Zi, scale as wo, scene as xo } from "./desk.js";
var Ji = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function es() {
  let e = Yi.peek(), t = [["scene", xo.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of Zi.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of Qi.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, r] of Object.entries(a)) t.push([o, r == null ? null : r * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, r) => {
      let [l, i] = [r % n.columns, Math.floor(r / n.columns)], u = ko(n.corner, ko(wo(n.u, (l + 0.5) / n.columns), wo(n.v, (i + 0.5) / n.rows)));
      t.push([...u.map((s) => s.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(Ji).join(",")).join(`\r
`) + `\r
`;
}
function Vn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function Mo() {
  let e = URL.createObjectURL(new Blob([es()], { type: "text/csv" }));
  Vn(`${xo.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var $o = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], It = new Uint8Array(512), An = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  It[e] = It[e + 255] = t, An[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var So = (e, t) => e && t ? It[An[e] + An[t]] : 0;
function ts(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let r = new Array(n.length + 1).fill(0);
    n.forEach((l, i) => {
      r[i] ^= l, r[i + 1] ^= So(l, It[o]);
    }), n = r;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let r = a[o];
    r && n.forEach((l, i) => a[o + i] ^= So(l, r));
  }
  return a.slice(e.length);
}
function ns(e, t) {
  let [n, a, o] = $o[t - 1], r = [], l = (g, m) => {
    for (let v = m - 1; v >= 0; v--) r.push(g >> v & 1);
  };
  for (l(4, 4), l(e.length, 8), e.forEach((g) => l(g, 8)), l(0, Math.min(4, n * 8 - r.length)); r.length % 8; ) r.push(0);
  let i = [];
  for (let g = 0; g < r.length; g += 8) i.push(parseInt(r.slice(g, g + 8).join(""), 2));
  for (let g = 236; i.length < n; g ^= 253) i.push(g);
  let u = n / o, s = Array.from({ length: o }, (g, m) => i.slice(m * u, (m + 1) * u)), p = s.map((g) => ts(g, a)), c = (g) => g[0].flatMap((m, v) => g.map((y) => y[v]));
  return [...c(s), ...c(p)];
}
var as = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function os(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function Co(e) {
  let t = e.length, n = 0, a = 0;
  for (let o of [!1, !0])
    for (let r = 0; r < t; r++) {
      let l = Array.from({ length: t }, (s, p) => o ? e[p][r] : e[r][p]), i = 1;
      for (let s = 1; s <= t; s++)
        s < t && l[s] === l[s - 1] ? i++ : (i >= 5 && (n += i - 2), i = 1);
      let u = l.map(Number).join("");
      for (let s = 0; s + 11 <= t; s++) {
        let p = u.slice(s, s + 11);
        (p === "10111010000" || p === "00001011101") && (n += 40);
      }
    }
  for (let o = 0; o < t; o++)
    for (let r = 0; r < t; r++)
      e[o][r] && a++, r && o && e[o][r] === e[o - 1][r] && e[o][r] === e[o][r - 1] && e[o][r] === e[o - 1][r - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function Lo(e) {
  let t = [...new TextEncoder().encode(e)], n = $o.findIndex(([m]) => t.length + 2 <= m) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), r = Array.from({ length: a }, () => new Array(a).fill(!1)), l = (m, v, y) => {
    m < 0 || v < 0 || m >= a || v >= a || (o[v][m] = y, r[v][m] = !0);
  };
  for (let m = 0; m < a; m++)
    l(m, 6, m % 2 === 0), l(6, m, m % 2 === 0);
  for (let [m, v] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let y = -4; y <= 4; y++)
      for (let V = -4; V <= 4; V++) {
        let B = Math.max(Math.abs(V), Math.abs(y));
        l(m + V, v + y, B !== 2 && B !== 4);
      }
  if (n > 1) {
    let m = a - 7;
    for (let v = -2; v <= 2; v++) for (let y = -2; y <= 2; y++) l(m + y, m + v, Math.max(Math.abs(y), Math.abs(v)) !== 1);
  }
  let i = (m) => {
    let v = os(m);
    for (let y = 0; y < 15; y++) {
      let V = (v >> y & 1) === 1, B = y < 6 ? y : y < 8 ? y + 1 : a - 15 + y;
      l(8, B, V), l(y < 8 ? a - 1 - y : y < 9 ? 7 : 14 - y, 8, V);
    }
    l(8, a - 8, !0);
  };
  i(0);
  let u = ns(t, n), s = 0;
  for (let m = a - 1; m > 0; m -= 2) {
    m === 6 && (m = 5);
    for (let v = 0; v < a; v++)
      for (let y of [m, m - 1]) {
        let B = (m + 1 & 2) === 0 ? a - 1 - v : v;
        r[B][y] || (o[B][y] = s < u.length * 8 && (u[s >> 3] >> 7 - (s & 7) & 1) === 1, s++);
      }
  }
  let p = (m) => (i(m), o.map((v, y) => v.map((V, B) => V !== (!r[y][B] && as[m](B, y))))), c = p(0), g = Co(c);
  for (let m = 1; m < 8; m++) {
    let v = p(m), y = Co(v);
    y < g && ([c, g] = [v, y]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as $s, jsx as h, jsxs as L } from "./desk.js";
function nt({ title: e, wide: t, children: n }) {
  let a = Ht(null);
  hs(() => {
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
var fs = [
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
function vs() {
  let e = [...new Set(In().map((t) => t.group))];
  return h(nt, { title: "All keys", wide: !0, children: L("div", { class: "help", children: [
    L("table", { children: [
      h("caption", { class: "spoken", children: "By hand" }),
      h("thead", { children: L("tr", { children: [
        h("th", { scope: "col", children: "What" }),
        h("th", { scope: "col", children: "Mouse" }),
        h("th", { scope: "col", children: "Keys, in the view" }),
        h("th", { scope: "col", children: "Fingers" })
      ] }) }),
      h("tbody", { children: fs.map(([t, n, a, o]) => L("tr", { children: [
        h("th", { scope: "row", children: t }),
        h("td", { children: n }),
        h("td", { children: a.replace("walking keys", gs.value) }),
        h("td", { children: o })
      ] }, t)) })
    ] }),
    L("div", { class: "columns", children: [
      e.map((t) => L("section", { children: [
        h("h3", { children: t }),
        h("dl", { children: In().filter((n) => n.group === t && n.keys).map((n) => L($s, { children: [
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
var qt = tt(""), Je = tt(0);
function ys() {
  let e = qt.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = In().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: bs(a.id), run: () => Po(a.id) }));
  for (let { name: a, camera: o } of ht())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => us(o, a) });
  if (e.length)
    for (let [a, o] of ps.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => ms("lamp", a) });
    }
  return n.slice(0, 60);
}
function ks() {
  let e = ys(), t = Math.min(Je.value, e.length - 1);
  Rn(() => {
    qt.value = "", Je.value = 0;
  }, []), Rn(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (et.value = null, a.why ? Ft(a.why, "warn") : setTimeout(a.run, 0));
  };
  return L(nt, { title: "Command palette", children: [
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
        value: qt.value,
        onInput: (a) => {
          qt.value = a.currentTarget.value, Je.value = 0;
        },
        onKeyDown: (a) => {
          let o = { ArrowDown: 1, ArrowUp: -1 }[a.key];
          o && (a.preventDefault(), Je.value = (t + o + e.length) % Math.max(1, e.length)), a.key === "Enter" && (a.preventDefault(), n(e[t]));
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
var To = tt([]);
cs("links", (e) => To.value = e.links);
function ws({ text: e }) {
  let t = Lo(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, r) => o.map((l, i) => l ? `M${i + 4} ${r + 4}h1v1h-1z` : "").join("")).join("");
  return L("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    h("rect", { width: n, height: n, fill: "#fff" }),
    h("path", { d: a, fill: "#000" })
  ] });
}
function xs() {
  let e = tt(null), t = Ht(e).current;
  return Rn(() => {
    Rt({ do: "links", what: "list" });
  }, []), L(nt, { title: "Share by link", children: [
    h("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    h("ul", { class: "links", children: To.value.map((n) => L("li", { children: [
      h("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      h("code", { children: n.address }),
      L("span", { class: "buttons", children: [
        h("button", { onClick: () => {
          is(n.address);
        }, children: "Copy" }),
        h("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        h("button", { onClick: () => Rt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && h(ws, { text: n.address })
    ] }, n.id)) }),
    L("footer", { children: [
      h("button", { onClick: () => Rt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      h("button", { onClick: () => Rt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function Ms() {
  let e = Ht(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    rs({ do: "save", name: n }), et.value = null, Ft(`Saving the version “${n}”.`);
  };
  return L(nt, { title: "Save a version", children: [
    h("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    L("label", { class: "line", children: [
      h("span", { children: "Name" }),
      h("span", { class: "field", children: h("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    h("footer", { children: h("button", { onClick: t, children: "Save" }) })
  ] });
}
var ee = tt(null);
function Ss() {
  let e = ds.value?.head, t = Ht(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    ee.value = 0;
    let [o, r] = [Number(n("width")), Number(n("height"))];
    ls("picture", { format: n("format"), width: o, height: r, batches: Number(n("batches")) }, (l) => {
      l.why ? (ee.value = null, Ft(l.why, "warn")) : l.url ? (ee.value = null, Vn(l.name, l.url), et.value = null) : ee.value = l.progress ?? 0;
    }, (l) => {
      ee.value = null, Ft(l, "warn");
    });
  };
  return L(nt, { title: "Save the picture", children: [
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
      h("button", { onClick: () => Po("command"), children: "Copy the command" }),
      h("button", { disabled: ee.value !== null, onClick: a, children: ee.value === null ? "Render and save" : ee.value ? `${ss(ee.value * 100)} %` : "Rendering…" })
    ] })
  ] });
}
function Cs() {
  switch (et.value) {
    case "help":
      return h(vs, {});
    case "palette":
      return h(ks, {});
    case "share":
      return h(xs, {});
    case "save":
      return h(Ms, {});
    case "picture":
      return h(Ss, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import {
  act as Ls,
  colorText as Eo,
  cost as Ps,
  css as Ts,
  Field as Es,
  groups as Vs,
  hovered as Nt,
  Icon as As,
  lamps as Is,
  lumensOf as Rs,
  penless as qs,
  pickRow as Fs,
  select as Hs,
  selection as Vo,
  switchOn as Ns,
  three as Os,
  typeGroupLevel as Ds,
  typeLevel as Ws
} from "./desk.js";
import { jsx as Y, jsxs as qn } from "./desk.js";
function Gs() {
  return qn("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    Y("span", {}),
    Y("span", { children: "Name" }),
    Y("span", { children: "Level" }),
    Y("span", { children: "lm" }),
    Y("span", { children: "White" })
  ] });
}
function Ks({ row: e, index: t, count: n }) {
  let a = e.kind === "lamp" ? Is.get(e.id) : void 0, o = e.kind === "group" ? Vs.get(e.id) : void 0, r = a ?? o;
  if (!r) return null;
  let l = Vo.value?.kind === e.kind && Vo.value.ids.includes(e.id), i = Rs(o?.lamps ?? [e.id]), u = qs.value, s = Nt.value?.kind === e.kind && Nt.value.id === e.id;
  return qn(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${l ? "selected" : ""} ${r.on ? "" : "off"} ${s ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => Nt.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => Nt.value = null,
      children: [
        Y("button", { class: "icon power", "aria-pressed": r.on, disabled: u !== null, title: u ?? void 0, "aria-label": `${r.name} on`, onClick: () => Ns(e, !r.on), children: Y(As, { name: "power" }) }),
        Y("button", { class: "row-name", "aria-pressed": l, title: a ? Ps(a) : void 0, onClick: (p) => Fs(p, e.kind, e.id), onDblClick: () => Ls("frame"), children: Y("span", { children: r.name }) }),
        Y(
          Es,
          {
            label: `${r.name} level`,
            quantity: "level",
            value: r.level,
            flux: a?.flux,
            step: 0.01,
            disabled: u !== null,
            why: u,
            set: (p) => a ? Ws([e.id], p) : Ds(e.id, p)
          }
        ),
        Y("span", { class: "lumens", children: Os(i) }),
        a ? qn("button", { class: "tint", "aria-label": `${r.name} colour: ${Eo(a)}`, onClick: () => Hs("lamp", e.id), children: [
          Y("i", { class: "swatch", style: { background: Ts(a.swatch) } }),
          Eo(a)
        ] }) : Y("span", {})
      ]
    }
  );
}

// src/later/strip.tsx
import {
  act as Fn,
  command as Ho,
  digits as Hn,
  fade as Ot,
  Field as Bs,
  grids as Ao,
  Icon as He,
  looks as Io,
  luxText as be,
  maintenance as Us,
  meters as Ro,
  select as qo,
  selection as Dt,
  signal as _s,
  status as Nn,
  storeLook as js
} from "./desk.js";
import { Fragment as Zs, jsx as x, jsxs as H } from "./desk.js";
var On = _s("looks");
function zs() {
  return H("section", { class: "looks", "aria-label": "Looks", children: [
    H("header", { children: [
      x("h2", { children: "Looks" }),
      x("button", { class: "tab", onClick: () => On.value = "meters", children: "Meters" }),
      x("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: js, children: x(He, { name: "plus" }) }),
      x("span", { class: "gap" }),
      H("label", { class: "tint", children: [
        "Fade",
        x(Bs, { label: "Cross-fade", quantity: "seconds", value: Ot.value, step: 0.5, set: (e) => Ot.value = Math.max(0, e(Ot.value)) })
      ] })
    ] }),
    H("ul", { children: [
      Io.all().map(([e, t], n) => H("li", { class: "look", children: [
        H("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Ho({ do: "look", id: e, what: "recall", seconds: Ot.peek() }), children: [
          t.picture && x("img", { src: t.picture, alt: "" }),
          x("span", { children: t.name })
        ] }),
        x(Xs, { id: e, name: t.name })
      ] }, e)),
      !Io.ids.value.length && x("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function Xs({ id: e, name: t }) {
  let n = `look-${e}`, a = (i) => {
    let u = i.getBoundingClientRect(), s = document.getElementById(n);
    s?.style.setProperty("left", `${Math.min(u.left, innerWidth - 296)}px`), s?.style.setProperty("bottom", `${innerHeight - u.top + 4}px`), s?.style.setProperty("top", "auto");
  }, o = { popovertarget: n }, r = () => document.getElementById(n)?.hidePopover(), l = (i, u = {}) => {
    r(), Ho({ do: "look", id: e, what: i, ...u });
  };
  return H(Zs, { children: [
    x("button", { class: "icon more", ...o, "aria-label": `More of ${t}`, onPointerDown: (i) => a(i.currentTarget), onFocus: (i) => a(i.currentTarget), children: x(He, { name: "more" }) }),
    H("div", { id: n, popover: "auto", class: "menu", children: [
      H("label", { class: "line", children: [
        x("span", { children: "Name" }),
        x("span", { class: "field", children: x("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (i) => l("rename", { name: i.currentTarget.value }) }) })
      ] }),
      x("button", { class: "item", onClick: () => l("update"), children: x("span", { children: "Update to what is set now" }) }),
      x("button", { class: "item", onClick: () => l("recall", { seconds: 0 }), children: x("span", { children: "Recall at once" }) }),
      x("button", { class: "item", onClick: () => l("remove"), children: x("span", { children: "Remove" }) })
    ] })
  ] });
}
var Fo = () => Nn.value?.stage === "moving" || Nn.value?.stage === "refining" || Nn.value?.stage === "loading";
function Qs() {
  let e = Us.value;
  return H("section", { class: "readings", "aria-label": "Meters and grids", children: [
    H("header", { children: [
      x("h2", { children: "Meters" }),
      x("button", { class: "tab", onClick: () => On.value = "looks", children: "Looks" }),
      x("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => Fn("meter-tool"), children: x(He, { name: "meter" }) }),
      x("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => Fn("grid"), children: x(He, { name: "grid" }) }),
      x("button", { onClick: () => Fn("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      x("button", { onClick: Mo, title: "Save all figures as CSV", children: "CSV" }),
      x("span", { class: "gap" }),
      x("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${Hn(e, 2)} maintained` })
    ] }),
    H("ul", { children: [
      Ro.all().map(([t, n]) => {
        let a = n.lux, o = a?.[1] == null || a[1] > 0.02 * a[0] || Fo();
        return x("li", { children: H("button", { class: "reading", "aria-pressed": Dt.value?.kind === "meter" && Dt.value.ids.includes(t), onClick: () => qo("meter", t), children: [
          H("span", { class: "tint", children: [
            x(He, { name: "meter" }),
            n.name
          ] }),
          x("strong", { class: o ? "unsettled" : "", children: a ? be(a[0] * e) : "…" }),
          H("small", { children: [
            a?.[1] != null ? `±${be(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind,
            n.target ? ` · wants ${be(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      Ao.all().map(([t, n]) => {
        let a = n.target, o = n.mean == null || n.error == null || n.error > 0.05 * n.mean || Fo(), r = a && n.mean != null && n.uniformity != null && n.mean * e >= a.lux && n.uniformity >= a.uniformity;
        return x("li", { children: H("button", { class: "reading", "aria-pressed": Dt.value?.kind === "grid" && Dt.value.ids.includes(t), onClick: () => qo("grid", t), children: [
          H("span", { class: "tint", children: [
            x(He, { name: "grid" }),
            n.name,
            " ",
            a && n.mean != null && x("b", { class: r ? "met" : "missed", children: r ? "✓" : "✗" })
          ] }),
          x("strong", { class: o ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${be(n.mean * e)}${n.error == null ? "" : ` ±${be(n.error * e, !1)}`}` }),
          H("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : Hn(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : be(n.min * e, !1),
            " to",
            " ",
            n.max == null ? "…" : be(n.max * e, !1),
            a ? ` · wants ${be(a.lux)}, U₀ ${Hn(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !Ro.ids.value.length && !Ao.ids.value.length && x("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Ys() {
  return H("div", { class: "strip-parts", "data-tab": On.value, children: [
    x(zs, {}),
    x(Qs, {})
  ] });
}

// src/later/menus.tsx
import {
  camera as Do,
  digits as Wo,
  display as Js,
  Field as Gt,
  go as Go,
  houseLights as Dn,
  Item as Me,
  Range as eu,
  show as Wn,
  theme as No,
  walking as tu
} from "./desk.js";
import { Fragment as Kt, jsx as S, jsxs as te } from "./desk.js";
var Wt = Math.PI / 360;
function Oo(e) {
  let t = Do.peek();
  t && Go({ ...t, fov: Math.max(3, Math.min(140, e)) });
}
function nu() {
  let e = Do.value, t = ht();
  return te(Kt, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((n) => S(Me, { id: n }, n)),
    S("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((n) => S(Me, { id: `preset-${n}` }, n)),
    S("hr", {}),
    t.length > 0 && S("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    t.map(({ name: n, camera: a }, o) => S("button", { class: "item", onClick: () => Go(a, n), children: S("span", { children: n }) }, o)),
    t.length > 0 && S("hr", {}),
    e && !e.height && te(Kt, { children: [
      te("label", { class: "line", children: [
        S("span", { children: "Angle" }),
        S(Gt, { label: "Vertical angle of view", quantity: "angle", value: e.fov, step: 1, set: (n) => Oo(n(e.fov)) })
      ] }),
      te("label", { class: "line", children: [
        S("span", { children: "Focal length" }),
        S(Gt, { label: "Focal length on 36 × 24 mm", quantity: "number", value: Math.round(120 / Math.tan(e.fov * Wt)) / 10, text: `${Wo(12 / Math.tan(e.fov * Wt), 1)} mm`, step: 1, set: (n) => Oo(Math.atan(12 / Math.max(2, n(12 / Math.tan(e.fov * Wt)))) / Wt) })
      ] }),
      S("hr", {})
    ] }),
    S(Me, { id: "walking", label: tu.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    S(Me, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((n) => S(Me, { id: `hands-${n}` }, n))
  ] });
}
var au = ["linear", "reinhard", "filmic"];
function ou() {
  let e = Js.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return te(Kt, { children: [
    te("fieldset", { children: [
      S("legend", { children: "Tone curve" }),
      S("div", { class: "segments", children: au.map((n) => S("button", { "aria-pressed": e.tone === n, onClick: () => Wn({ tone: n }), children: n }, n)) })
    ] }),
    te("fieldset", { children: [
      S("legend", { children: "White balance" }),
      te("label", { class: "line", children: [
        S("span", { children: "White" }),
        S(Gt, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => Wn({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      te("label", { class: "line", children: [
        S("span", { children: "Tint" }),
        S(Gt, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => Wn({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    S("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => S(Me, { id: n }, n))
  ] });
}
function lu() {
  return te(Kt, { children: [
    te("label", { class: "line", children: [
      S("span", { children: "House lights" }),
      S(eu, { label: "House lights", value: Dn.value, text: `${Wo(Dn.value * 100)} %`, on: (e) => Dn.value = Math.max(0.3, e) })
    ] }),
    S("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => S("button", { "aria-pressed": No.value === e, onClick: () => No.value = e, children: e }, e)) }),
    S("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => S(Me, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as Bt, cut as ru, digits as Ko, edit as Bo, go as iu, Icon as at, Range as su, setCut as uu, signal as cu, storeView as pu, viewName as mu, views as du } from "./desk.js";
import { jsx as W, jsxs as Gn } from "./desk.js";
var Ut = cu(null);
function hu() {
  let e = du.all();
  return Gn("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    W("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => Bt("home"), children: W(at, { name: "home" }) }),
    W("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => Bt("frame"), children: W(at, { name: "frame" }) }),
    W("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => Bt("back"), children: W(at, { name: "back" }) }),
    W("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => Bt("forth"), children: W(at, { name: "forth" }) }),
    W("span", { class: "divide" }),
    e.map(([t, n], a) => Ut.value === t ? W("span", { class: "field", children: W(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (o) => o?.focus(),
        onBlur: (o) => {
          let r = o.currentTarget.value.trim();
          Ut.value = null, r && r !== n.name && Bo(`Rename the view ${r}`, { views: { [t]: { ...n, name: r } } });
        },
        onKeyDown: (o) => {
          o.stopPropagation(), o.key === "Escape" && (o.currentTarget.value = n.name ?? ""), (o.key === "Enter" || o.key === "Escape") && o.currentTarget.blur();
        }
      }
    ) }, t) : Gn(
      "button",
      {
        class: "saved-view",
        "aria-pressed": mu.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click or F2 renames, Delete removes`,
        onClick: () => iu(n, n.name ?? "view"),
        onDblClick: () => Ut.value = t,
        onKeyDown: (o) => {
          o.key === "F2" && (Ut.value = t), o.key === "Delete" && (o.stopPropagation(), Bo(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          W("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    W("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: pu, children: W(at, { name: "plus" }) })
  ] });
}
function gu() {
  let e = ru.value;
  if (!e) return null;
  let t = e.height === null ? `${Ko(e.value, 2)} m` : `at ${Ko(e.height, 2)} m`;
  return Gn("label", { class: "cut", "data-scroll": !0, children: [
    W("span", { children: "Cut" }),
    W(
      su,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => uu(n * e.most)
      }
    ),
    W("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as bu, useRef as fu } from "./desk.js";
import { jsx as Uo } from "./desk.js";
function vu() {
  let e = fu(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let r = a.getBoundingClientRect(), l = (s) => Math.max(-1, Math.min(1, s)), i = o ? 0 : l((n.clientX - r.left) / (r.width / 2) - 1), u = o ? 0 : l(1 - (n.clientY - r.top) / (r.height / 2));
    e.current?.style.setProperty("transform", `translate(${i * 28}px, ${-u * 28}px)`), bu(u, i);
  };
  return Uo("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: Uo("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as _o,
  closeWhat as jo,
  digits as yu,
  hovered as zo,
  Icon as ku,
  lamps as wu,
  luxText as fe,
  nameOf as xu,
  select as Mu,
  useEffect as Su,
  useRef as Cu,
  viewSize as $u,
  what as Lu
} from "./desk.js";
import { jsx as K, jsxs as ne } from "./desk.js";
var Se = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], Pu = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function Tu() {
  let e = Lu.value, t = Cu(null);
  if (Su(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = $u.value, o = [...e.lamps].sort((c, g) => Se(g) - Se(c)), r = o.reduce((c, g) => c + Se(g), 0) || 1, l = o.slice(0, 9), i = r - l.reduce((c, g) => c + Se(g), 0), u = Math.max(8, Math.min(e.x + 12, n - 332)), s = Math.max(8, Math.min(e.y + 12, a - 150 - 35 * l.length)), p = e.lux ? `${fe(e.lux[0])} ±${fe(e.lux[1], !1)}` : "Measuring…";
  return ne(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${u}px`, top: `${s}px` },
      onKeyDown: (c) => {
        c.key === "Escape" && (c.stopPropagation(), jo(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        ne("header", { children: [
          K("strong", { class: e.done ? "" : "unsettled", children: p }),
          K("span", { class: "quiet", children: "what lights this" }),
          K("button", { class: "icon", "aria-label": "Close", onClick: jo, children: K(ku, { name: "close" }) })
        ] }),
        ne("ol", { children: [
          l.map((c) => K(
            "li",
            {
              onPointerEnter: () => zo.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => zo.value = null,
              children: ne("button", { class: "row", onClick: () => Mu("lamp", c.id), children: [
                K("span", { class: "name", children: xu("lamp", c.id) }),
                ne("span", { class: "figure", children: [
                  yu(100 * Se(c) / r, Se(c) / r < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                ne("span", { class: "figure lux", children: [
                  fe(Se(c)),
                  " ±",
                  fe(Pu(c), !1)
                ] }),
                ne("span", { class: "shares", "aria-hidden": "true", children: [
                  K("i", { class: "direct", style: { width: `${100 * c.direct[0] / r}%` } }),
                  K("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / r}%` } }),
                  K("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / r}%` } })
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
            fe(i)
          ] }),
          !o.length && K("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        ne("footer", { children: [
          K("span", { class: "key direct", children: "direct" }),
          K("span", { class: "key indirect", children: "indirect" }),
          K("span", { class: "key caustic", children: "caustic" }),
          K("span", { class: "gap" }),
          _o.value.some((c) => wu.get(c)?.place?.direction) && K("button", { onClick: () => Be(_o.peek(), e.hit.point), children: "Aim here" }),
          K("button", { onClick: () => Ue(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Xl as Compare,
  gu as CutBar,
  Vr as Gizmo,
  Oi as Inspector,
  Xi as Legend,
  lu as PageItems,
  ou as SeeingItems,
  Gs as SheetHead,
  Ks as SheetRow,
  Cs as Sheets,
  Ys as Strip,
  nu as ViewItems,
  hu as ViewStrip,
  vu as WalkPad,
  Tu as What
};
