// src/later/actions.ts
import {
  adding as nl,
  asked as al,
  ask as ol,
  back as ll,
  candles as Yn,
  chosenLamps as ue,
  clearSolo as rl,
  command as Qt,
  compareHeld as il,
  copyText as sl,
  deselect as ul,
  each as Zt,
  edit as Jt,
  exposeBy as Zn,
  falseColor as cl,
  fine as Jn,
  forth as pl,
  frameSelection as dl,
  go as ml,
  goHome as hl,
  goInside as gl,
  goPreset as bl,
  handles as ea,
  hands as fl,
  here as vl,
  highlight as yl,
  history as ta,
  lampMarks as na,
  lamps as ut,
  listing as aa,
  lookOnly as oa,
  panels as la,
  PRESETS as kl,
  register as wl,
  say as st,
  scene as xl,
  selection as pa,
  send as Ml,
  sheet as _e,
  show as Sl,
  soloSelection as Cl,
  spot as je,
  startTool as Se,
  stepSelection as ra,
  storeLook as $l,
  storeView as Ll,
  theme as ia,
  things as sa,
  titleOf as da,
  toggleFalse as Pl,
  toggleWipe as Tl,
  travel as ua,
  views as El,
  walking as Yt,
  whyNot as Q
} from "./desk.js";

// src/later/tools.ts
import {
  add as Ge,
  adding as Uo,
  chosenLamps as _o,
  cross as jo,
  distance as zo,
  dot as Wt,
  edit as Gt,
  effect as Xo,
  free as zn,
  grids as Un,
  lamps as Ke,
  meters as _n,
  normal as Kt,
  onTool as Qo,
  positionOf as Yo,
  say as Bt,
  scale as fe,
  select as Zo,
  step as Ut,
  sub as _t,
  titleOf as jt,
  tool as Me,
  up as Xn
} from "./desk.js";
var We = null;
Xo(() => {
  Me.value !== "grid" && (We = null);
});
function Jo(e) {
  if (!e) return Bt("There is nothing at that point.", "warn");
  switch (Me.peek()) {
    case "aim":
      Be(_o.peek(), e.point), Me.value = null;
      break;
    case "meter":
      Ue(e.point, e.normal), Me.value = null;
      break;
    case "grid":
      if (!We) {
        We = e;
        return;
      }
      el(We.point, e.point), We = null, Me.value = null;
      break;
    case "add":
      tl(Uo.peek(), e), Me.value = null;
      break;
  }
}
Qo(Jo);
function Be(e, t) {
  let n = {};
  for (let a of e) {
    let o = Ke.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: Kt(_t(t, o.position)) } });
  }
  if (!Object.keys(n).length) return Bt("What is selected shines into all directions: it cannot be aimed.", "warn");
  Gt(`Aim ${jt(e)}`, { lamps: n });
}
function zt(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let l = o.filter((r) => !n.has(r));
    l.length && (Zo(t, l[l.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), 3e3);
}
function Ue(e, t) {
  let n = zn(_n);
  zt(_n, "meter"), Gt("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function Xt(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
function el(e, t, n = { lux: 500, uniformity: 0.6 }) {
  let a = Xn.peek(), o = Math.abs(a[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], l = Kt(jo(a, o)), r = _t(t, e), [i, u] = [Wt(r, o), Wt(r, l)];
  if (Math.abs(i) < 0.05 || Math.abs(u) < 0.05) return Bt("An area needs two corners that lie apart.", "warn");
  let s = Ge(e, Ge(fe(o, Math.min(i, 0)), fe(l, Math.min(u, 0))));
  [i, u] = [Math.abs(i), Math.abs(u)];
  let p = (g) => Math.max(1, Math.ceil(g / Xt(Math.max(i, u)))), c = zn(Un);
  zt(Un, "grid"), Gt("Lay a grid", {
    grids: {
      [c]: {
        name: `Area ${c + 1}`,
        corner: s,
        u: fe(o, i),
        v: fe(l, u),
        normal: a,
        columns: p(i),
        rows: p(u),
        target: n
      }
    }
  });
}
var jn = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function tl(e, t) {
  let n = Xn.peek(), a = Wt(t.normal, n), o = a > 0.7 ? Ge(t.point, fe(n, 1.2)) : Ge(t.point, fe(t.normal, 0.15)), l = a > 0.7 || a < -0.7 ? fe(n, -1) : t.normal, r = { position: o };
  e !== "point" && e !== "sphere" && (r.direction = l), e === "spot" && Object.assign(r, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (r.radius = 0.15), e === "sphere" && (r.radius = 0.08);
  let i = Ke.all().filter(([, u]) => u.own).length;
  zt(Ke, "lamp"), Ut(`Add ${jn[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${jn[e] ?? e} ${i + 1}`, kind: e, flux: 800, place: r }
  });
}
function lt(e, t, n) {
  !e.length || t < 1 || Ut(`Copy ${jt(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function Qn(e) {
  e.length && Ut(`Remove ${jt(e)}`, { do: "remove", lamps: e });
}
function rt(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = Ke.get(o)?.place, r = n.get(o);
    if (!r) continue;
    let i = Ge(r, t), u = l?.aim && zo(l.aim, i) > 1e-6 ? { direction: Kt(_t(l.aim, i)) } : {};
    a[o] = { place: { position: i, ...u } };
  }
  return { lamps: a };
}
function it(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = Ke.get(n), o = a && Yo(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/actions.ts
var se = () => Q() ?? (ue.value.length ? null : "Select a lamp first.");
function Vl() {
  let e = ue.peek(), t = !e.some((n) => ut.get(n)?.on);
  Jt(`${da(e)} ${t ? "on" : "off"}`, { lamps: Zt(e, { on: t }) });
}
function Al() {
  let e = ue.peek(), t = !e.every((n) => ut.get(n)?.parked);
  Jt(`${t ? "Park" : "Unpark"} ${da(e)}`, { lamps: Zt(e, { parked: t }) });
}
function ca(e) {
  let t = pa.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : sa.ids.peek().filter((a) => sa.get(a)?.hidden);
  if (!n.length) return st(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Jt(e ? "Hide things" : "Show hidden things", { things: Zt(n, { hidden: e }) });
}
function Il() {
  let e = ue.peek()[0], t = ut.get(e)?.place, n = vl();
  if (!t?.position || !t.direction || !n) return st("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  ml({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function Rl() {
  ol("command", {}, (e) => {
    sl(e.text);
  });
}
var ql = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Fl = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, Hl = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: dl },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: hl },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: gl },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: ll },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: pl },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Ll, why: Q },
  ...kl.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Fl[e],
    keys: `Shift+${t + 1}`,
    run: () => bl(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      Yt.value = Yt.peek() === "walk" ? "fly" : "walk", st(Yt.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: Il, why: se },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => ra(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => ra(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => Se("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => pa.value = { kind: "lamp", ids: ut.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: ul },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: Vl, why: se },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Cl, why: () => ue.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: rl },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => yl(!0), why: se },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Al, why: se },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => Se("aim"), why: se },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => je.peek() && Be(ue.peek(), je.peek().point), why: se },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => ea.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => ea.value = "turn" },
  ...ql.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: Q,
    run: () => {
      nl.value = e, Se("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => lt(ue.peek(), 1, [0.5, 0, 0]), why: se },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => Qn(ue.peek()), why: se },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => ca(!0), why: Q },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => ca(!1), why: Q },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => Qt({ do: "undo" }), why: () => Q() ?? (ta.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => Qt({ do: "redo" }), why: () => Q() ?? (ta.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => _e.value = "save", why: Q },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => _e.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Rl },
  { id: "share", group: "Work", label: "Share by link", run: () => _e.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: Pl },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = cl();
      Sl({ false_color: { ...al(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => Zn(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => Zn(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => Ml({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => il(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: Tl },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: Q, run: () => je.peek() ? Ue(je.peek().point, je.peek().normal) : Se("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => Se("meter"), why: Q },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => Se("grid"), why: Q },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => Qt({ do: "reach" }), why: Q },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => Yn.value = Yn.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: $l, why: Q },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => st("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => la.value = !la.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => aa.value = aa.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => ua.value = ua.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => na.value = !na.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => Jn.value = !Jn.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => ia.value = ia.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => oa.value = !oa.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => fl.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => _e.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => _e.value = "palette" }
];
wl(Hl);
function ct() {
  return [...(xl.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...El.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as Nl, comparing as Dl, digits as Ol, fitted as Wl, useEffect as Gl, useRef as Kl, viewSize as Bl, wipeAt as en } from "./desk.js";
import { Fragment as _l, jsx as tn, jsxs as jl } from "./desk.js";
function Ul() {
  let e = Dl.value, t = Nl.value, n = Kl(null);
  if (Gl(() => {
    let s = n.current;
    !s || !t || (s.width = t.picture.width, s.height = t.picture.height, s.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = Bl.value, o = en.value, l = Wl(t.picture.width, t.picture.height), r = Math.max(0, Math.min(1, (o * a - l.x) / (t.picture.width * l.scale))), i = (s) => {
    let p = s.currentTarget;
    if (s.stopPropagation(), s.type === "pointerdown") p.setPointerCapture(s.pointerId);
    else if (p.hasPointerCapture(s.pointerId)) {
      let c = p.parentElement.getBoundingClientRect();
      en.value = Math.max(0, Math.min(1, (s.clientX - c.left) / c.width));
    }
  }, u = (s) => {
    let p = { ArrowLeft: -0.02, ArrowRight: 0.02 }[s.key];
    p && (s.stopPropagation(), s.preventDefault(), en.value = Math.max(0, Math.min(1, o + p)));
  };
  return jl(_l, { children: [
    tn(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * r}% 0 0)` : "none" }
      }
    ),
    tn("span", { class: "tag left", children: "before" }),
    e === "wipe" && tn(
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
        "aria-valuetext": `${Ol(o * 100)} % before`,
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
  add as va,
  chosenLamps as nr,
  computed as on,
  editor as ar,
  effect as or,
  fitted as lr,
  Gesture as rr,
  handles as ir,
  lamps as dt,
  lookOnly as sr,
  middle as ur,
  nameOf as cr,
  normal as pr,
  pinhole as dr,
  positionOf as ka,
  role as mr,
  selection as hr,
  shown as gr,
  sub as br,
  things as mt,
  titleOf as fr,
  tool as vr,
  turn as ya,
  useEffect as yr,
  useRef as kr,
  viewSize as wr
} from "./desk.js";

// src/later/gizmo.ts
import { project as ma, ray as zl } from "./desk.js";
import { across as Xl, add as te, cross as Ql, distance as Yl, dot as ce, length as Zl, normal as nn, scale as ne, sub as Ce } from "./desk.js";
var Jl = "http://www.w3.org/2000/svg", an = 84, ve = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], pt = ["x", "y", "z"], ha = 0.1, er = 5 * Math.PI / 180, ga = 48;
function fa(e, t) {
  let n = (m, b, k) => {
    let w = document.createElementNS(Jl, m);
    return w.setAttribute("class", k), b.append(w), w;
  }, a = (m, b, k) => {
    let w = n("g", e, `handle ${m} ${pt[b] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), l = ve.map((m, b) => a("ring", b, `ring-${pt[b]}`)), r = ve.map((m, b) => a("plane", b, `plane-${pt[b]}`)), i = ve.map((m, b) => a("arrow", b, `move-${pt[b]}`)), u = a("centre", -1, "move-view"), s = a("aim", -1, "aim"), p = n("text", e, "handle-text"), c = (m, b) => {
    let [k, w, T] = ma(m.hole, b);
    return T < 0.02 && !m.hole.parallel ? null : [m.fit.x + k * m.fit.scale, m.fit.y + w * m.fit.scale];
  }, g = (m, b) => {
    let k = ma(m.hole, b)[2];
    return an / m.fit.scale * m.hole.pixel * (m.hole.parallel ? 1 : Math.max(k, 0.02));
  }, d = (m, b, k = !1) => {
    let w = b.filter((S) => S !== null), T = w.length < b.length || w.length < 2 ? "" : `M${w.map((S) => `${S[0].toFixed(1)} ${S[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    m.setAttribute("d", T);
  }, f = (m, b, k) => {
    m.setAttribute("d", b ? `M${b[0] - k} ${b[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, v = (m, b) => m.forEach((k) => k.group.classList.toggle("gone", !b));
  function V(m, b) {
    let k = m.position, w = c(b, k), T = g(b, k), S = m.mode === "move";
    v([...i, ...r, u], S && w !== null), v(l, !S && w !== null && m.turns);
    let j = m.aim ?? (m.direction ? te(k, ne(m.direction, 3 * T)) : null);
    if (v([s], j !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    ve.forEach((O, U) => {
      let R = c(b, te(k, ne(O, T))), nt = R ? Math.hypot(R[0] - w[0], R[1] - w[1]) < 12 : !0;
      if (i[U].group.classList.toggle("gone", !S || nt), R && S) {
        let [be, De] = [(R[0] - w[0]) / an, (R[1] - w[1]) / an], ot = Math.hypot(be, De) || 1, [ie, Oe] = [be / ot, De / ot], Ot = [w[0] + 14 * ie, w[1] + 14 * Oe];
        d(i[U].hit, [Ot, R]), i[U].seen.setAttribute("d", `M${Ot[0].toFixed(1)} ${Ot[1].toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}M${(R[0] - 9 * ie - 4.5 * Oe).toFixed(1)} ${(R[1] - 9 * Oe + 4.5 * ie).toFixed(1)}L${R[0].toFixed(1)} ${R[1].toFixed(1)}L${(R[0] - 9 * ie + 4.5 * Oe).toFixed(1)} ${(R[1] - 9 * Oe - 4.5 * ie).toFixed(1)}`);
      }
      let [He, Ne] = [ve[(U + 1) % 3], ve[(U + 2) % 3]], Z = Math.abs(ce(O, b.hole.parallel ? b.hole.forward : nn(Ce(k, b.hole.eye)))) < 0.15;
      r[U].group.classList.toggle("gone", !S || Z);
      let at = (be, De) => c(b, te(k, te(ne(He, be * T), ne(Ne, De * T)))), Bn = [at(0.3, 0.3), at(0.5, 0.3), at(0.5, 0.5), at(0.3, 0.5)];
      if (d(r[U].hit, Bn, !0), d(r[U].seen, Bn, !0), !S) {
        let be = Array.from({ length: ga + 1 }, (De, ot) => {
          let ie = 2 * Math.PI * ot / ga;
          return c(b, te(k, te(ne(He, Math.cos(ie) * T), ne(Ne, Math.sin(ie) * T))));
        });
        d(l[U].hit, be), d(l[U].seen, be);
      }
    }), f(u.hit, w, 13), f(u.seen, w, 7);
    let I = j && c(b, j);
    d(o, [w, I]), f(s.hit, I, 16), s.seen.setAttribute("d", I ? `M${I[0] - 8} ${I[1]}h16M${I[0]} ${I[1] - 8}v16M${I[0] - 5} ${I[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let B = t.effect(() => {
    let m = t.target.value, b = t.view.value;
    e.classList.toggle("empty", !m || !b), m && b && V(m, b);
  }), Wn = (m, b, k) => zl(m.hole, (b.clientX - k.left - m.fit.x) / m.fit.scale, (b.clientY - k.top - m.fit.y) / m.fit.scale);
  function Fe(m, b, k) {
    m.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let T = t.view.peek();
      if (!T || !t.target.peek()) return;
      let S = e.getBoundingClientRect(), j = k(T), I = t.hold(b), O = Wn(T, w, S);
      j(O, !1, { ...I, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), m.setPointerCapture(w.pointerId), m.classList.add("held");
      let U = (Z) => {
        p.textContent = j(Wn(T, Z, S), Z.ctrlKey || Z.metaKey, I), p.setAttribute("x", String(Z.clientX - S.left + 16)), p.setAttribute("y", String(Z.clientY - S.top - 12));
      }, R = (Z) => {
        m.removeEventListener("pointermove", U), m.removeEventListener("pointerup", nt), m.removeEventListener("pointercancel", He), removeEventListener("keydown", Ne, !0), m.classList.remove("held"), p.textContent = "", Z ? I.end() : I.cancel();
      }, nt = () => R(!0), He = () => R(!1), Ne = (Z) => {
        Z.key === "Escape" && (Z.stopPropagation(), R(!1));
      };
      m.addEventListener("pointermove", U), m.addEventListener("pointerup", nt), m.addEventListener("pointercancel", He), addEventListener("keydown", Ne, !0);
    });
  }
  let Nt = (m, b, k) => k ? Math.round(m / b) * b : m, Dt = (m) => m.map((b) => b.toFixed(2)).join("  ") + " m";
  ve.forEach((m, b) => {
    Fe(i[b].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (T, S, j) => {
        let I = tr(k, m, T);
        w ??= I;
        let O = ne(m, Nt(I - w, ha, S));
        return j.move(O), Dt(O);
      };
    }), Fe(r[b].group, "move", () => Gn(m)), Fe(l[b].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (T, S, j) => {
        let I = ba(k.position, m, T), O = I && nn(Ce(I, k.position), Xl(m));
        if (!O) return "";
        w.at ??= O;
        let U = Math.atan2(ce(m, Ql(w.at, O)), ce(w.at, O)), R = Nt(U, er, S);
        return j.rotate(m, R), `${(R * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), Fe(u.group, "move", (m) => Gn(m.hole.forward)), Fe(s.group, "aim", (m) => {
    let b = t.target.peek(), k = b.aim ?? te(b.position, ne(b.direction, 3 * g(m, b.position))), w = Kn(k, m.hole.forward);
    return (T, S, j) => {
      let I = w(T, S), O = te(k, I);
      return Yl(O, b.position) > 1e-3 && j.turn(nn(Ce(O, b.position)), O), Dt(O);
    };
  });
  function Gn(m) {
    let b = Kn(t.target.peek().position, m);
    return (k, w, T) => {
      let S = b(k, w);
      return T.move(S), Dt(S);
    };
  }
  function Kn(m, b) {
    let k = null;
    return (w, T) => {
      let S = ba(m, b, w);
      return S ? (k ??= S, Ce(S, k).map((j) => Nt(j, ha, T))) : [0, 0, 0];
    };
  }
  return { stop: B };
}
function tr(e, t, n) {
  let a = Ce(e, n.origin), o = ce(t, n.direction), l = 1 - o * o;
  return l < 1e-6 ? 0 : (o * ce(n.direction, a) - ce(t, a)) / l;
}
function ba(e, t, n) {
  let a = ce(t, n.direction);
  if (Math.abs(a) < 1e-4 * Zl(t)) return null;
  let o = ce(Ce(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : te(n.origin, ne(n.direction, o));
}

// src/later/handles.tsx
import { jsx as Pr } from "./desk.js";
function xr([e, t, n, a], [o, l, r, i]) {
  return [
    a * o + e * i + t * r - n * l,
    a * l - e * r + t * i + n * o,
    a * r + e * l - t * o + n * i,
    a * i - e * o - t * l - n * r
  ];
}
var Mr = () => !sr.value && mr.value !== "watch" && ar.value.you && vr.value !== "aim", wa = on(() => {
  let e = hr.value;
  if (!e || !Mr()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => mt.get(a) && !mt.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = nr.value.filter((n) => ka(dt.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), xa = (e) => {
  let t = mt.get(e);
  return t?.place?.position ?? (t?.box ? ur(t.box) : null);
}, Sr = on(() => {
  let e = wa.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? ka(dt.get(t)) : xa(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? dt.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: ir.value
  };
}), Cr = on(() => {
  let e = gr.value;
  if (wr.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: dr(e.camera, t, n), fit: lr(t, n) };
}), $r = {
  effect: or,
  target: Sr,
  view: Cr,
  hold(e) {
    let t = wa.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? fr(n) : n.length === 1 ? cr("thing", n[0]) : `${n.length} things`, l = new rr(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), r = a === "lamps" ? it(n) : new Map(n.map((s) => [s, xa(s)])), i = new Map(n.map((s) => [s, (a === "lamps" ? dt : mt).get(s)?.place])), u = (s) => {
      let p = n.map((c) => [c, s(c)]).filter(([, c]) => c);
      l.set({ [a]: Object.fromEntries(p.map(([c, g]) => [c, { place: g }])) });
    };
    return {
      move: (s) => a === "lamps" ? l.set(rt(n, s, r)) : u((p) => ({ position: va(r.get(p), s) })),
      turn: (s, p) => u((c) => i.get(c)?.direction ? { direction: s, ...p ? { aim: p } : {} } : null),
      rotate: (s, p) => u((c) => {
        let g = i.get(c);
        if (g?.direction) {
          let v = pr(ya(g.direction, s, p)), V = g.aim && g.position ? ya(br(g.aim, g.position), s, p) : null;
          return { direction: v, ...V ? { aim: va(g.position, V) } : {} };
        }
        let d = Math.sin(p / 2), f = [s[0] * d, s[1] * d, s[2] * d, Math.cos(p / 2)];
        return { rotation: xr(f, g?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => l.end(),
      cancel: () => l.cancel()
    };
  }
};
function Lr() {
  let e = kr(null);
  return yr(() => fa(e.current, $r).stop, []), Pr("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as ho, deselect as Ei, Icon as Sn, penless as Cn, selection as Vi, signal as Ai } from "./desk.js";

// src/later/measure.tsx
import {
  deselect as Ca,
  digits as Pe,
  edit as gt,
  grids as Rr,
  Icon as $a,
  length as Te,
  luxText as Ee,
  maintenance as ln,
  meters as qr,
  selection as La
} from "./desk.js";

// src/later/parts.tsx
import { Field as Ma, Gesture as Tr, Range as Er, stroke as Vr, useRef as Ar } from "./desk.js";
import { jsx as ae, jsxs as ht } from "./desk.js";
function q({ title: e, note: t, children: n }) {
  return ht("section", { class: "part", "aria-label": e, children: [
    ht("h3", { children: [
      e,
      t && ae("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function G(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function A(e) {
  return ht("label", { class: "line", children: [
    ae("span", { children: e.label }),
    ae(Ma, { ...e, label: e.name ?? e.label })
  ] });
}
function Ir(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function J({ label: e, names: t, quantity: n, value: a, set: o, step: l, disabled: r }) {
  let i = t ?? ["X", "Y", "Z"];
  return ht("div", { class: "line", role: "group", "aria-label": e, children: [
    ae("span", { children: e }),
    ae("span", { class: "triple", children: i.map((u, s) => ae(
      Ma,
      {
        label: `${e} ${u}`,
        quantity: n,
        value: a[s],
        text: Ir(a[s], n),
        step: l,
        disabled: r,
        set: (p) => o(s, p)
      },
      u
    )) })
  ] });
}
function $e({ label: e, name: t, value: n, text: a, patch: o, reset: l, notch: r, class: i, style: u, disabled: s }) {
  let p = Ar(null), c = (d) => () => {
    p.current?.[d](), p.current = null;
  }, g = (d) => p.current ? p.current.set(o(d)) : Vr(e + t, t, o(d));
  return ae(
    Er,
    {
      label: e,
      value: n,
      text: a,
      notch: r,
      class: i,
      gradient: u,
      disabled: s,
      begin: () => p.current = new Tr(t),
      on: g,
      end: c("end"),
      cancel: c("cancel"),
      reset: l === void 0 ? void 0 : () => g(l)
    }
  );
}
function Le({ value: e, label: t, set: n }) {
  return ae("span", { class: "field name-field", children: ae(
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
var oe = (e, t, n) => e.map((a, o) => o === t ? n(a) : a);

// src/later/measure.tsx
import { Fragment as rn, jsx as L, jsxs as _ } from "./desk.js";
var Fr = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function Pa() {
  let e = La.value?.ids[0], t = qr.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: l, ...r } = { ...t, ...o };
    gt(`${t.name}: ${a}`, { meters: { [e]: r } });
  };
  return _(rn, { children: [
    L("header", { class: "panel-head", children: L(Le, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    L("p", { class: "crumbs", children: t.lux ? `${Ee(t.lux[0] * ln.value)} ±${Ee(t.lux[1] * ln.value, !1)}` : "measuring" }),
    L("div", { class: "scroll", children: _(q, { title: "Meter", children: [
      _("label", { class: "line", children: [
        L("span", { children: "Measures" }),
        L("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: Fr.map(([a, o]) => L("option", { value: a, children: o }, a)) })
      ] }),
      L(J, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: oe(t.point, a, o) }) }),
      L(A, { label: "Shall read", quantity: "lux", step: 50, value: t.target ?? 0, set: (a) => n("target", { target: a(t.target ?? 0) || null }) }),
      L(J, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: oe(t.normal, a, o) }) }),
      _("button", { class: "plain full", onClick: () => {
        Ca(), gt(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        L($a, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var Sa = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function Ta() {
  let e = La.value?.ids[0], t = Rr.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This grid is gone." });
  let n = ln.value, a = (i, u) => {
    let { name: s, corner: p, u: c, v: g, normal: d, columns: f, rows: v, target: V } = { ...t, ...u };
    gt(`${t.name}: ${i}`, { grids: { [e]: { name: s, corner: p, u: c, v: g, normal: d, columns: f, rows: v, target: V } } });
  }, o = () => {
    let i = Xt(Math.max(Te(t.u), Te(t.v)));
    a("standard spacing", { columns: Math.max(1, Math.ceil(Te(t.u) / i)), rows: Math.max(1, Math.ceil(Te(t.v) / i)) });
  }, l = (i, u, s) => _(rn, { children: [
    L("dt", { children: i }),
    L("dd", { children: u == null ? "…" : s(u) })
  ] }), r = t.target ?? { lux: 500, uniformity: 0.6 };
  return _(rn, { children: [
    L("header", { class: "panel-head", children: L(Le, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    _("p", { class: "crumbs", children: [
      Pe(Te(t.u), 2),
      " × ",
      Pe(Te(t.v), 2),
      " m, ",
      Pe(t.columns * t.rows),
      " points"
    ] }),
    _("div", { class: "scroll", children: [
      L(q, { title: "Figures", note: n === 1 ? "new" : `× ${Pe(n, 2)}`, children: _("dl", { class: "figures", children: [
        l("Ē", t.mean, (i) => Ee(i * n)),
        l("E min", t.min, (i) => Ee(i * n)),
        l("E max", t.max, (i) => Ee(i * n)),
        l("U₀ = min / mean", t.uniformity, (i) => Pe(i, 2)),
        l("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => Pe(i, 2)),
        l("± of Ē", t.error, (i) => Ee(i * n))
      ] }) }),
      _(q, { title: "Target", children: [
        _("label", { class: "line", children: [
          L("span", { children: "Class" }),
          _("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let u = Sa[Number(i.currentTarget.value)];
            a("target", { target: u ? { lux: u[1], uniformity: u[2] } : null });
          }, children: [
            L("option", { value: "", children: t.target ? "choose…" : "none" }),
            Sa.map(([i, u, s], p) => _("option", { value: p, children: [
              i,
              ": ",
              u,
              " lx, U₀ ",
              s
            ] }, i)),
            L("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        L(A, { label: "Ē at least", quantity: "lux", step: 50, value: r.lux, set: (i) => a("target", { target: { ...r, lux: i(r.lux) } }) }),
        L(A, { label: "U₀ at least", quantity: "share", step: 0.05, value: r.uniformity, set: (i) => a("target", { target: { ...r, uniformity: i(r.uniformity) } }) })
      ] }),
      _(q, { title: "Area", children: [
        L(J, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, u) => a("move", { corner: oe(t.corner, i, u) }) }),
        L(A, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        L(A, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        L("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: o, children: "Spacing of the standard" }),
        _("button", { class: "plain full", onClick: () => {
          Ca(), gt(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          L($a, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as ke,
  chosenLamps as Qr,
  dot as dn,
  edit as vt,
  format as Oa,
  groups as yt,
  handles as bt,
  Icon as Ae,
  lamps as bn,
  layers as Yr,
  normal as Wa,
  output as Ga,
  percent as gn,
  positionOf as Ra,
  selection as mn,
  signal as Ka,
  spot as Zr,
  sub as qa,
  titleOf as fn,
  tool as Jr,
  toLevel as Fa,
  toTravel as ei,
  typeLevel as hn,
  up as ti,
  Fade as ni,
  Field as ai,
  wantLevel as Ha,
  compass as Ba,
  add as kt,
  scale as Ie,
  length as oi,
  Range as li,
  strokeLevel as Na,
  useRef as ri
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as Or,
  digits as Va,
  edit as Wr,
  fromHex as Gr,
  hex as Kr,
  lamps as Aa,
  mired as ye,
  titleOf as Br
} from "./desk.js";

// src/later/white.ts
import { css as Hr, mired as sn } from "./desk.js";
function Nr(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((l) => Math.max(0, l));
}
function Dr(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function Ea(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, l) => {
    let r = sn(e) + (sn(t) - sn(e)) * l / (n - 1);
    return Hr(Nr(...Dr(1e6 / r)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as cn, jsx as N, jsxs as pe } from "./desk.js";
var ze = 1800, pn = 1e4, Ur = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], _r = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], jr = Ea(ze, pn), un = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(Aa.get(n).color) }]))
}), zr = (e) => {
  let t = 1e6 / (ye(ze) + (ye(pn) - ye(ze)) * e);
  return Math.round(t / 10) * 10;
}, Xr = (e) => (ye(e) - ye(ze)) / (ye(pn) - ye(ze));
function Ia() {
  let e = Or.value, t = e.map((r) => Aa.get(r)?.color).filter((r) => r !== void 0);
  if (!t.length) return null;
  let n = G(t.map((r) => r.mode)), a = t[0], o = Br(e), l = (r, i) => Wr(`${o}: ${r}`, un(e, i));
  return pe(cn, { children: [
    pe("div", { class: "line", children: [
      N("span", { children: "Colour" }),
      N("div", { class: "segments", role: "group", "aria-label": "Colour by", children: _r.map(([r, i]) => N("button", { "aria-pressed": n === r, onClick: () => l(`colour by ${i}`, () => ({ mode: r })), children: i }, r)) })
    ] }),
    n === "kelvin" && pe(cn, { children: [
      pe("div", { class: "line slide", children: [
        N("span", { children: "White" }),
        N(
          $e,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: jr,
            value: Xr(a.kelvin),
            text: `${Va(a.kelvin)} kelvin`,
            patch: (r) => un(e, () => ({ mode: "kelvin", kelvin: zr(r) }))
          }
        )
      ] }),
      N(
        A,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: G(t.map((r) => r.kelvin)),
          step: 50,
          set: (r) => l("white", (i) => ({ mode: "kelvin", kelvin: r(i.kelvin) }))
        }
      ),
      N("div", { class: "whites", role: "group", "aria-label": "Whites", children: Ur.map(([r, i]) => N("button", { title: i, "aria-label": `${r} kelvin, ${i}`, onClick: () => l(`${r} K`, () => ({ mode: "kelvin", kelvin: r })), children: r }, r)) }),
      pe("div", { class: "line slide", children: [
        N("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        N(
          $e,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${Va(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (r) => un(e, () => ({ tint: Math.round((r * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      N(A, { label: "", name: "Tint, typed", quantity: "number", value: G(t.map((r) => r.tint)), step: 1, set: (r) => l("tint", (i) => ({ tint: Math.max(-50, Math.min(50, r(i.tint))) })) })
    ] }),
    n === "rgb" && pe(cn, { children: [
      pe("label", { class: "line", children: [
        N("span", { children: "Colour" }),
        N("input", { type: "color", class: "pick", "aria-label": "Colour", value: Kr(a.rgb), onChange: (r) => l("colour", () => ({ mode: "rgb", rgb: Gr(r.currentTarget.value) })) })
      ] }),
      N(
        J,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (r, i) => l("colour", (u) => ({ rgb: u.rgb.map((s, p) => p === r ? Math.max(0, i(s)) : s) }))
        }
      )
    ] }),
    n === "xy" && pe("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      N("span", { children: "x, y" }),
      N("span", { class: "triple", children: [0, 1].map((r) => N(
        A,
        {
          label: "xy"[r],
          quantity: "number",
          step: 1e-3,
          value: G(t.map((i) => i.xy[r])),
          set: (i) => l("chromaticity", (u) => ({ xy: u.xy.map((s, p) => p === r ? Math.max(0.01, Math.min(0.9, i(s))) : s) }))
        },
        r
      )) })
    ] }),
    n === null && N("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as vn, jsx as y, jsxs as D } from "./desk.js";
var Ve = Ka(1), ft = Ka([1, 0, 0]), ii = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], wt = 180 / Math.PI;
function Da(e, t) {
  let { right: n, ahead: a } = Ba(t), o = -dn(e, t);
  return [Math.atan2(dn(e, n), dn(e, a)) * wt, Math.asin(Math.max(-1, Math.min(1, o))) * wt];
}
function si(e, t, n) {
  let { right: a, ahead: o } = Ba(n), [l, r] = [e / wt, t / wt], i = kt(Ie(a, Math.sin(l)), Ie(o, Math.cos(l)));
  return Wa(kt(Ie(i, Math.cos(r)), Ie(n, -Math.sin(r))));
}
function ui({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction);
  return D("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    D("button", { "aria-pressed": Jr.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => ke("aim"), children: [
      y(Ae, { name: "aim" }),
      "Aim"
    ] }),
    y("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => ke("solo"), children: y(Ae, { name: "solo" }) }),
    y("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => ke("from-lamp"), children: y(Ae, { name: "eye" }) }),
    y("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => ke("frame"), children: y(Ae, { name: "frame" }) }),
    y("span", { class: "gap" }),
    y("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => ke("park"), children: "Park" }),
    y("button", { class: "icon", "aria-label": `Remove ${fn(e)}`, title: "Remove (Del)", onClick: () => ke("remove"), children: y(Ae, { name: "bin" }) })
  ] });
}
function ci({ ids: e, all: t }) {
  let n = G(t.map((r) => r.level)), a = t.reduce((r, i) => r + i.flux * Ga(i), 0), o = t.every((r) => r.free), l = e[e.length - 1];
  return D(q, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    D("div", { class: "line slide", children: [
      y("span", { children: "Level" }),
      y(pi, { id: l })
    ] }),
    D("label", { class: "line", children: [
      y("span", {}),
      y(
        ai,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: G(t.map((r) => r.flux)) ?? void 0,
          step: 0.01,
          set: (r) => hn(e, r),
          open: Ha.value,
          opened: () => Ha.value = "",
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
        set: (r) => hn(e, (i, u) => r(i * u) / u)
      }
    ),
    D("div", { class: "line", children: [
      y("span", { children: "Stops" }),
      y("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: ii.map(([r, i]) => y("button", { "aria-label": `${i} stop`, onClick: () => hn(e, (u) => Math.min(1e3, u * 2 ** r)), children: i }, i)) })
    ] }),
    D("p", { class: "sum", children: [
      Oa(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (yt.get(t[0].group)?.level ?? 1) !== 1 && ` (${gn(t[0].level)} % × ${gn(yt.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    y(Ia, {})
  ] });
}
function pi({ id: e }) {
  let t = ri(null), n = bn.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (l) => () => {
    t.current?.[l](), t.current = null;
  };
  return y(
    li,
    {
      label: "Level",
      value: ei(n.level),
      text: `${gn(n.level)} %, ${Oa(n.flux * Ga(n), "flux")}`,
      begin: () => t.current = new ni(a),
      on: (l) => t.current ? t.current.to(Fa(l)) : Na(a, Fa(l)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => Na(a, 1)
    }
  );
}
function Xe(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = bn.get(o), r = n(l.place ?? {}, l);
    r && (a[o] = { place: r });
  }
  Object.keys(a).length && vt(`${fn(e)}: ${t}`, { lamps: a });
}
function di({ ids: e, all: t }) {
  let n = (o) => G(t.map((l) => l.place?.[o] ?? null)), a = (o) => t.some((l) => l.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : D(q, { title: "Beam", note: "re-trace", children: [
    a("outer") && D(vn, { children: [
      y(A, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => Xe(e, "beam", (l) => l.outer == null ? null : { inner: Math.max(0.1, Math.min(l.outer, o(l.inner ?? l.outer))) }) }),
      y(A, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => Xe(e, "beam", (l) => {
        if (l.outer == null) return null;
        let r = Math.max(0.2, Math.min(179, o(l.outer)));
        return { outer: r, inner: Math.min(l.inner ?? r, r) };
      }) })
    ] }),
    a("radius") && y(A, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => Xe(e, "radius", (l) => l.radius == null ? null : { radius: Math.max(1e-3, o(l.radius)) }) })
  ] });
}
function mi({ ids: e, all: t }) {
  let n = t.filter((c) => Ra(c) !== null);
  if (!n.length) return null;
  let a = n.map((c) => Ra(c)), o = (c, g) => G(g.map((d) => Math.round(d[c] * 1e4) / 1e4)), l = t.filter((c) => c.place?.direction), r = ti.value, i = l.map((c) => Da(c.place?.direction, r).map((g) => Math.round(g * 10) / 10)), u = t.map((c) => c.place?.aim).filter((c) => !!c), s = (c, g) => {
    let d = it(e), f = {};
    for (let [v, V] of d) {
      let B = [0, 0, 0];
      B[c] = g(V[c]) - V[c], Object.assign(f, rt([v], B, d).lamps);
    }
    vt(`Move ${fn(e)}`, { lamps: f });
  }, p = (c, g) => Xe(e, c ? "tilt" : "pan", (d) => {
    if (!d.direction) return null;
    let f = Da(d.direction, r);
    f[c] = g(f[c]);
    let v = si(f[0], Math.max(-90, Math.min(90, f[1])), r), V = d.aim && d.position ? oi(qa(d.aim, d.position)) : 0;
    return { direction: v, ...V && d.position ? { aim: kt(d.position, Ie(v, V)) } : {} };
  });
  return D(q, { title: "Place", note: "re-trace", children: [
    y(J, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => o(c, a)), set: s }),
    l.length > 0 && D(vn, { children: [
      y(A, { label: "Pan", quantity: "angle", step: 1, value: G(i.map((c) => c[0])), set: (c) => p(0, c) }),
      y(A, { label: "Tilt", quantity: "angle", step: 1, value: G(i.map((c) => c[1])), set: (c) => p(1, c) }),
      y(
        J,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: u.length ? [0, 1, 2].map((c) => o(c, u)) : [NaN, NaN, NaN],
          set: (c, g) => Xe(e, "aim", (d) => {
            if (!d.direction || !d.position) return null;
            let f = oe(d.aim ?? kt(d.position, Ie(d.direction, 2)), c, g);
            return { aim: f, direction: Wa(qa(f, d.position)) };
          })
        }
      )
    ] }),
    D("div", { class: "line", children: [
      y("span", { children: "Handles" }),
      D("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        y("button", { "aria-pressed": bt.value === "move", onClick: () => bt.value = "move", children: "Move" }),
        y("button", { "aria-pressed": bt.value === "turn", onClick: () => bt.value = "turn", children: "Turn" })
      ] })
    ] }),
    l.length > 0 && Zr.value && y("button", { class: "plain full", onClick: () => ke("aim-here"), children: "Aim at the last point" })
  ] });
}
function hi({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : D(q, { title: "Copies along a line", children: [
    y(A, { label: "How many", quantity: "number", step: 1, value: Ve.value, set: (n) => Ve.value = Math.max(1, Math.min(100, Math.round(n(Ve.value)))) }),
    y(J, { label: "Step", quantity: "length", step: 0.05, value: ft.value, set: (n, a) => ft.value = oe(ft.value, n, a) }),
    D("button", { class: "plain full", onClick: () => lt(e, Ve.value, ft.value), children: [
      y(Ae, { name: "copy" }),
      Ve.value === 1 ? "One copy" : `${Ve.value} copies`
    ] })
  ] });
}
function Ua() {
  let e = Qr.value, t = e.map((r) => bn.get(r)).filter((r) => !!r);
  if (!t.length) return y("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && yt.get(n.group), o = mn.value?.kind === "group" ? yt.get(mn.value.ids[0]) : void 0, l = n?.layer != null ? Yr.value[n.layer] : void 0;
  return D(vn, { children: [
    y("header", { class: "panel-head", children: n ? y(Le, { label: "Name of the lamp", value: n.name, set: (r) => vt(`Rename ${n.name}`, { lamps: { [e[0]]: { name: r } } }) }) : o ? y(Le, { label: "Name of the group", value: o.name, set: (r) => vt(`Rename ${o.name}`, { groups: { [mn.value.ids[0]]: { name: r } } }) }) : D("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    y("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${l ? ` ▸ ${l.name}` : ""}` : `${t.filter((r) => r.on).length} of ${t.length} on` }),
    D("div", { class: "scroll", children: [
      y(ui, { ids: e, all: t }),
      y(ci, { ids: e, all: t }),
      y(q, { title: "Photometry", children: y("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      y(di, { ids: e, all: t }),
      y(mi, { ids: e, all: t }),
      y(hi, { ids: e, all: t }),
      y("p", { class: "cost", children: t.every((r) => r.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as yn,
  candles as xt,
  command as gi,
  digits as St,
  edit as _a,
  Field as bi,
  filterOf as Qa,
  go as fi,
  history as vi,
  hovered as ja,
  Icon as Ct,
  layers as yi,
  lookOnly as za,
  maintenance as Re,
  materials as ki,
  percent as wi,
  scene as xi,
  select as Ya,
  signal as Mi,
  singleKeys as Xa,
  sub as Si,
  things as Ci,
  travel as Mt,
  Virtual as Za
} from "./desk.js";
import { Fragment as $i, jsx as M, jsxs as E } from "./desk.js";
function Ja() {
  let e = xi.value;
  if (!e) return null;
  let t = Si(e.bounds[1], e.bounds[0]);
  return E($i, { children: [
    E(q, { title: "Room", children: [
      E("p", { children: [
        t.map((n) => St(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${St(e.triangles)} triangles` : ""
      ] }),
      M("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && M("ul", { class: "buttons", children: e.cameras.map((n, a) => M("li", { children: M("button", { onClick: () => fi(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
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
        M(bi, { label: "Maintenance factor", quantity: "share", value: Re.value, step: 0.05, set: (n) => Re.value = Math.max(0.1, Math.min(1, n(Re.value))) })
      ] }),
      E("p", { class: "quiet", children: [
        Re.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Re.value === 1 && M("button", { class: "plain", onClick: () => Re.value = 0.8, children: "0.80" })
      ] }),
      E("div", { class: "line", children: [
        M("span", { children: "Unit" }),
        E("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          M("button", { "aria-pressed": xt.value === "lx", onClick: () => xt.value = "lx", children: "lx, cd/m²" }),
          M("button", { "aria-pressed": xt.value === "fc", onClick: () => xt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    M(q, { title: "Layers of light", children: M("ul", { class: "layers", children: yi.value.map((n, a) => E("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      M("i", { class: "dot", "aria-hidden": "true" }),
      M("span", { children: n.name || `layer ${a + 1}` }),
      M("small", { children: n.held ? "held" : wi(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    E(q, { title: "Hands", children: [
      E("div", { class: "line", children: [
        M("span", { children: "Faders" }),
        E("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          M("button", { "aria-pressed": Mt.value === "square", onClick: () => Mt.value = "square", children: "Square law" }),
          M("button", { "aria-pressed": Mt.value === "linear", onClick: () => Mt.value = "linear", children: "Even" })
        ] })
      ] }),
      E("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: Xa.value, onChange: (n) => Xa.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      E("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: za.value, onChange: (n) => za.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var $t = Mi("");
function eo({ label: e }) {
  return M("span", { class: "field filter", children: M("input", { type: "text", "aria-label": e, placeholder: "Filter", value: $t.value, onInput: (t) => $t.value = t.currentTarget.value }) });
}
function to() {
  let e = Qa(Ci, $t.value);
  return E("div", { class: "listing", children: [
    M(eo, { label: "Filter things" }),
    M(
      Za,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => ja.value = { kind: "thing", id: n }, onPointerLeave: () => ja.value = null, children: [
            M("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => _a(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: M(Ct, { name: a.hidden ? "eye-off" : "eye" }) }),
            M("button", { class: "row-name", onClick: () => Ya("thing", n), children: M("span", { children: a.name }) }),
            M("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => _a(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: M(Ct, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function no() {
  let e = Qa(ki, $t.value);
  return E("div", { class: "listing", children: [
    M(eo, { label: "Filter materials" }),
    M(
      Za,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row material", role: "listitem", children: [
            M("button", { class: "row-name", onClick: () => Ya("material", n), children: M("span", { children: a.name }) }),
            E("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${St(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function ao() {
  let e = vi.value;
  return E(q, { title: "History", children: [
    E("p", { children: [
      e.steps === 1 ? "One step" : `${St(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => yn("undo"), children: [
      M(Ct, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => yn("redo"), children: [
      M(Ct, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    M("button", { class: "plain full", onClick: () => yn("save"), children: "Save a version with a name…" }),
    M("button", { class: "plain full", onClick: () => gi({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as kn,
  edit as io,
  fromHex as Li,
  hex as Pi,
  Icon as oo,
  materials as so,
  middle as lo,
  select as uo,
  selection as co,
  things as wn
} from "./desk.js";
import { Fragment as Mn, jsx as C, jsxs as z } from "./desk.js";
var xn = 180 / Math.PI;
function ro(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * xn : 0;
}
function Ti(e, t) {
  let n = [0, 0, 0, Math.cos(t / xn / 2)];
  return n[e] = Math.sin(t / xn / 2), n;
}
function po() {
  let e = (co.value?.ids ?? []).filter((u) => wn.get(u)), t = e.map((u) => wn.get(u));
  if (!t.length) return C("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((u) => u.locked), l = (u, s) => io(`${a}: ${u}`, { things: Object.fromEntries(e.map((p, c) => [p, s(t[c])])) }), r = t.map((u) => u.place?.position ?? (u.box ? lo(u.box) : [0, 0, 0])), i = n.box ? [0, 1, 2].map((u) => n.box[1][u] - n.box[0][u]) : null;
  return z(Mn, { children: [
    C("header", { class: "panel-head", children: C("h2", { children: a }) }),
    i && z("p", { class: "crumbs", children: [
      i.map((u) => kn(u, 2)).join(" × "),
      " m"
    ] }),
    z("div", { class: "scroll", children: [
      z("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        z("button", { "aria-pressed": t.every((u) => u.hidden), onClick: () => l(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          C(oo, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        z("button", { "aria-pressed": o, onClick: () => l(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          C(oo, { name: o ? "lock" : "unlock" }),
          o ? "Locked" : "Lock"
        ] })
      ] }),
      z(q, { title: "Place", note: "re-trace", children: [
        o && C("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        C(
          J,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: o,
            value: [0, 1, 2].map((u) => G(r.map((s) => Math.round(s[u] * 1e4) / 1e4))),
            set: (u, s) => l("move", (p) => ({ place: { position: oe(p.place?.position ?? lo(p.box), u, s) } }))
          }
        ),
        [0, 1, 2].map((u) => C(
          A,
          {
            label: `Turn ${"XYZ"[u]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: G(t.map((s) => Math.round(ro(s.place?.rotation, u) * 10) / 10)),
            set: (s) => l("turn", (p) => ({ place: { rotation: Ti(u, s(ro(p.place?.rotation, u))) } }))
          },
          u
        )),
        C(
          A,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: o,
            value: G(t.map((u) => u.place?.scale ?? 1)),
            set: (u) => l("scale", (s) => ({ place: { scale: Math.max(1e-3, u(s.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      C(q, { title: "Materials", children: C("ul", { class: "buttons", children: n.materials.map((u) => C("li", { children: C("button", { onClick: () => uo("material", u), children: so.get(u)?.name ?? `material ${u}` }) }, u)) }) })
    ] })
  ] });
}
function mo() {
  let e = co.value?.ids[0], t = so.get(e);
  if (!t) return C("p", { class: "quiet empty", children: "This material is gone." });
  let n = (s, p) => io(`${t.name}: ${s}`, { materials: { [e]: p } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], r = ((s) => 0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2])(o), i = (s) => o.map((p) => Math.max(0, Math.min(1, r > 1e-4 ? p / r * s : s))), u = (s, p) => t[p] != null && z(Mn, { children: [
    z("div", { class: "line slide", children: [
      C("span", { children: s }),
      C($e, { label: s, name: `${t.name}: ${s.toLowerCase()}`, value: t[p], text: kn(t[p], 2), patch: (c) => ({ materials: { [e]: { [p]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    C(A, { label: "", name: `${s}, typed`, quantity: "share", step: 0.01, value: t[p], set: (c) => n(s.toLowerCase(), { [p]: Math.max(0, Math.min(1, c(t[p]))) }) })
  ] });
  return z(Mn, { children: [
    C("header", { class: "panel-head", children: C("h2", { children: t.name }) }),
    C("p", { class: "crumbs", children: t.kind }),
    z("div", { class: "scroll", children: [
      z(q, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        z("div", { class: "line slide", children: [
          C("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          C($e, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: r, text: kn(r, 2), patch: (s) => ({ materials: { [e]: { [a]: i(Math.min(0.95, s)) } } }) })
        ] }),
        C(A, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(r * 1e3) / 1e3, set: (s) => n("reflectance", { [a]: i(Math.min(0.98, s(r))) }) }),
        z("label", { class: "line", children: [
          C("span", { children: "Colour" }),
          C("input", { type: "color", class: "pick", "aria-label": "Colour", value: Pi(o), onChange: (s) => n("colour", { [a]: Li(s.currentTarget.value) }) })
        ] }),
        u("Roughness", "roughness"),
        u("Gloss", "specular")
      ] }),
      C(q, { title: "On", children: C("ul", { class: "buttons", children: wn.all().filter(([, s]) => s.materials.includes(e)).slice(0, 40).map(([s, p]) => C("li", { children: C("button", { onClick: () => uo("thing", s), children: p.name }) }, s)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as go, jsx as F, jsxs as Lt } from "./desk.js";
var Qe = ["Scene", "Things", "Materials", "History"], de = Ai("Scene");
function Ii() {
  let e = { Scene: Ja, Things: to, Materials: no, History: ao }[de.value];
  return Lt(go, { children: [
    F("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), de.value = Qe[(Qe.indexOf(de.value) + a + Qe.length) % Qe.length], document.getElementById(`tab-${de.value}`)?.focus());
    }, children: Qe.map((n) => F("button", { id: `tab-${n}`, role: "tab", "aria-selected": de.value === n, "aria-controls": "tab-panel", tabIndex: de.value === n ? 0 : -1, onClick: () => de.value = n, children: n }, n)) }),
    F("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${de.value}`, tabIndex: 0, children: F(e, {}) })
  ] });
}
function Ri() {
  let e = Vi.value;
  return e ? Lt(go, { children: [
    Lt("nav", { class: "chooser", "aria-label": "Selection", children: [
      F("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => ho("previous"), children: F(Sn, { name: "back" }) }),
      F("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => ho("next"), children: F(Sn, { name: "forth" }) }),
      F("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      F("span", { class: "gap" }),
      F("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: Ei, children: F(Sn, { name: "close" }) })
    ] }),
    Cn.value && F("p", { class: "penless", children: Cn.value }),
    Lt("fieldset", { class: "editing", disabled: Cn.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && F(Ua, {}),
      e.kind === "thing" && F(po, {}),
      e.kind === "material" && F(mo, {}),
      e.kind === "meter" && F(Pa, {}),
      e.kind === "grid" && F(Ta, {})
    ] })
  ] }) : F(Ii, {});
}

// src/later/legend.tsx
import { asked as qi, candles as Fi, display as Hi, Field as Ni, show as Di, three as Oi, useRef as Wi } from "./desk.js";
import { jsx as X, jsxs as Pt } from "./desk.js";
var $n = [1, 2, 5];
function Gi(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, l = 10 ** Math.floor(Math.log10(o)), r = l * ($n.find((i) => i * l >= o) ?? 10);
    for (let i = Math.ceil(e / r) * r; i <= t * 1.0001; i += r) a.push(i);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let l of $n) {
      let r = l * 10 ** o;
      r >= e * 0.999 && r <= t * 1.001 && a.push(r);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function Ki(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var le = (e, t) => {
  let n = qi({ ...e, ...t });
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && Di({ false_color: n });
};
function bo(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return $n[a] * 10 ** ((n - a) / 3);
}
function Bi() {
  let e = Hi.value.false_color, t = Wi(null);
  if (!e) return null;
  let n = Fi.value === "fc", a = e.quantity === "illuminance", o = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", l = n ? a ? 1 / 10.7639 : 0.2919 : 1, r = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, i = e.ticks ?? Gi(e.low, e.high, e.scale).map((p) => [p, Ki(p, e)]), u = (p) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: p, from: e[p] };
    },
    onPointerMove: (c) => {
      let g = t.current;
      g?.end === p && le(e, { [p]: bo(g.from, Math.round((g.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let g = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      g && (c.preventDefault(), c.stopPropagation(), le(e, { [p]: bo(e[p], g) }));
    }
  }), s = ({ end: p }) => Pt("div", { class: "end", children: [
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
        "aria-valuetext": `${Oi(e[p] * l)} ${o}`,
        ...u(p)
      }
    ),
    X(
      Ni,
      {
        label: p === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[p] * l).toPrecision(3)),
        set: (c) => le(e, { [p]: c(e[p] * l) / l })
      }
    )
  ] });
  return Pt("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    Pt("header", { children: [
      X(
        "button",
        {
          "aria-label": `${o}: ${a ? "illuminance" : "luminance"}, change`,
          onClick: () => le(e, { quantity: a ? "luminance" : "illuminance" }),
          children: o
        }
      ),
      X("button", { "aria-pressed": e.scale === "log", onClick: () => le(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      X("button", { "aria-pressed": e.lines, onClick: () => le(e, { lines: !e.lines }), children: "lines" })
    ] }),
    X(s, { end: "high" }),
    X("div", { class: "scale", style: { background: r }, children: i.map(([p, c]) => X("span", { style: { bottom: `${100 * c}%` }, children: String(Number((p * l).toPrecision(2))) }, p)) }),
    X(s, { end: "low" }),
    Pt("footer", { children: [
      X("button", { onClick: () => le(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      X("button", { onClick: () => le(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      X(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (p) => le(e, { palette: p.currentTarget.value }),
          children: e.palettes?.map((p) => X("option", { children: p }, p)) ?? X("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as Tn,
  act as Co,
  ask as es,
  command as ts,
  copyText as ns,
  digits as as,
  go as os,
  hear as ls,
  lamps as rs,
  say as Vn,
  select as is,
  send as Et,
  sheet as Ze,
  shown as ss,
  signal as Je,
  useEffect as En,
  useLayoutEffect as us,
  useRef as At,
  walkNames as cs,
  whyNotTo as ps
} from "./desk.js";

// src/later/csv.ts
import { add as fo, grids as Ui, maintenance as _i, meters as ji, scale as vo, scene as yo } from "./desk.js";
var zi = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function Xi() {
  let e = _i.peek(), t = [["scene", yo.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of ji.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of Ui.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, l] of Object.entries(a)) t.push([o, l == null ? null : l * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, l) => {
      let [r, i] = [l % n.columns, Math.floor(l / n.columns)], u = fo(n.corner, fo(vo(n.u, (r + 0.5) / n.columns), vo(n.v, (i + 0.5) / n.rows)));
      t.push([...u.map((s) => s.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(zi).join(",")).join(`\r
`) + `\r
`;
}
function Ln(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function ko() {
  let e = URL.createObjectURL(new Blob([Xi()], { type: "text/csv" }));
  Ln(`${yo.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var Mo = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], Tt = new Uint8Array(512), Pn = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  Tt[e] = Tt[e + 255] = t, Pn[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var wo = (e, t) => e && t ? Tt[Pn[e] + Pn[t]] : 0;
function Qi(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let l = new Array(n.length + 1).fill(0);
    n.forEach((r, i) => {
      l[i] ^= r, l[i + 1] ^= wo(r, Tt[o]);
    }), n = l;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let l = a[o];
    l && n.forEach((r, i) => a[o + i] ^= wo(r, l));
  }
  return a.slice(e.length);
}
function Yi(e, t) {
  let [n, a, o] = Mo[t - 1], l = [], r = (g, d) => {
    for (let f = d - 1; f >= 0; f--) l.push(g >> f & 1);
  };
  for (r(4, 4), r(e.length, 8), e.forEach((g) => r(g, 8)), r(0, Math.min(4, n * 8 - l.length)); l.length % 8; ) l.push(0);
  let i = [];
  for (let g = 0; g < l.length; g += 8) i.push(parseInt(l.slice(g, g + 8).join(""), 2));
  for (let g = 236; i.length < n; g ^= 253) i.push(g);
  let u = n / o, s = Array.from({ length: o }, (g, d) => i.slice(d * u, (d + 1) * u)), p = s.map((g) => Qi(g, a)), c = (g) => g[0].flatMap((d, f) => g.map((v) => v[f]));
  return [...c(s), ...c(p)];
}
var Zi = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function Ji(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function xo(e) {
  let t = e.length, n = 0, a = 0;
  for (let o of [!1, !0])
    for (let l = 0; l < t; l++) {
      let r = Array.from({ length: t }, (s, p) => o ? e[p][l] : e[l][p]), i = 1;
      for (let s = 1; s <= t; s++)
        s < t && r[s] === r[s - 1] ? i++ : (i >= 5 && (n += i - 2), i = 1);
      let u = r.map(Number).join("");
      for (let s = 0; s + 11 <= t; s++) {
        let p = u.slice(s, s + 11);
        (p === "10111010000" || p === "00001011101") && (n += 40);
      }
    }
  for (let o = 0; o < t; o++)
    for (let l = 0; l < t; l++)
      e[o][l] && a++, l && o && e[o][l] === e[o - 1][l] && e[o][l] === e[o][l - 1] && e[o][l] === e[o - 1][l - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function So(e) {
  let t = [...new TextEncoder().encode(e)], n = Mo.findIndex(([d]) => t.length + 2 <= d) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), l = Array.from({ length: a }, () => new Array(a).fill(!1)), r = (d, f, v) => {
    d < 0 || f < 0 || d >= a || f >= a || (o[f][d] = v, l[f][d] = !0);
  };
  for (let d = 0; d < a; d++)
    r(d, 6, d % 2 === 0), r(6, d, d % 2 === 0);
  for (let [d, f] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let v = -4; v <= 4; v++)
      for (let V = -4; V <= 4; V++) {
        let B = Math.max(Math.abs(V), Math.abs(v));
        r(d + V, f + v, B !== 2 && B !== 4);
      }
  if (n > 1) {
    let d = a - 7;
    for (let f = -2; f <= 2; f++) for (let v = -2; v <= 2; v++) r(d + v, d + f, Math.max(Math.abs(v), Math.abs(f)) !== 1);
  }
  let i = (d) => {
    let f = Ji(d);
    for (let v = 0; v < 15; v++) {
      let V = (f >> v & 1) === 1, B = v < 6 ? v : v < 8 ? v + 1 : a - 15 + v;
      r(8, B, V), r(v < 8 ? a - 1 - v : v < 9 ? 7 : 14 - v, 8, V);
    }
    r(8, a - 8, !0);
  };
  i(0);
  let u = Yi(t, n), s = 0;
  for (let d = a - 1; d > 0; d -= 2) {
    d === 6 && (d = 5);
    for (let f = 0; f < a; f++)
      for (let v of [d, d - 1]) {
        let B = (d + 1 & 2) === 0 ? a - 1 - f : f;
        l[B][v] || (o[B][v] = s < u.length * 8 && (u[s >> 3] >> 7 - (s & 7) & 1) === 1, s++);
      }
  }
  let p = (d) => (i(d), o.map((f, v) => f.map((V, B) => V !== (!l[v][B] && Zi[d](B, v))))), c = p(0), g = xo(c);
  for (let d = 1; d < 8; d++) {
    let f = p(d), v = xo(f);
    v < g && ([c, g] = [f, v]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as ws, jsx as h, jsxs as $ } from "./desk.js";
function et({ title: e, wide: t, children: n }) {
  let a = At(null);
  us(() => {
    let l = a.current, r = document.activeElement;
    return l.open || l.showModal(), () => r?.focus();
  }, []);
  let o = () => Ze.value = null;
  return h(
    "dialog",
    {
      ref: a,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: o,
      onClick: (l) => l.target === a.current && o(),
      children: $("div", { class: "sheet-body", children: [
        $("header", { children: [
          h("h2", { children: e }),
          h("span", { class: "gap" }),
          h("button", { onClick: o, children: "Close" })
        ] }),
        n
      ] })
    }
  );
}
var ds = [
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
function ms() {
  let e = [...new Set(Tn().map((t) => t.group))];
  return h(et, { title: "All keys", wide: !0, children: $("div", { class: "help", children: [
    $("table", { children: [
      h("caption", { class: "spoken", children: "By hand" }),
      h("thead", { children: $("tr", { children: [
        h("th", { scope: "col", children: "What" }),
        h("th", { scope: "col", children: "Mouse" }),
        h("th", { scope: "col", children: "Keys, in the view" }),
        h("th", { scope: "col", children: "Fingers" })
      ] }) }),
      h("tbody", { children: ds.map(([t, n, a, o]) => $("tr", { children: [
        h("th", { scope: "row", children: t }),
        h("td", { children: n }),
        h("td", { children: a.replace("walking keys", cs.value) }),
        h("td", { children: o })
      ] }, t)) })
    ] }),
    $("div", { class: "columns", children: [
      e.map((t) => $("section", { children: [
        h("h3", { children: t }),
        h("dl", { children: Tn().filter((n) => n.group === t && n.keys).map((n) => $(ws, { children: [
          h("dt", { children: n.label }),
          h("dd", { children: h("kbd", { children: n.keys }) })
        ] })) })
      ] }, t)),
      $("section", { children: [
        h("h3", { children: "Numbers" }),
        $("dl", { children: [
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
var Vt = Je(""), Ye = Je(0);
function hs() {
  let e = Vt.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = Tn().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: ps(a.id), run: () => Co(a.id) }));
  for (let { name: a, camera: o } of ct())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => os(o, a) });
  if (e.length)
    for (let [a, o] of rs.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => is("lamp", a) });
    }
  return n.slice(0, 60);
}
function gs() {
  let e = hs(), t = Math.min(Ye.value, e.length - 1);
  En(() => {
    Vt.value = "", Ye.value = 0;
  }, []), En(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (Ze.value = null, a.why ? Vn(a.why, "warn") : setTimeout(a.run, 0));
  };
  return $(et, { title: "Command palette", children: [
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
        value: Vt.value,
        onInput: (a) => {
          Vt.value = a.currentTarget.value, Ye.value = 0;
        },
        onKeyDown: (a) => {
          let o = { ArrowDown: 1, ArrowUp: -1 }[a.key];
          o && (a.preventDefault(), Ye.value = (t + o + e.length) % Math.max(1, e.length)), a.key === "Enter" && (a.preventDefault(), n(e[t]));
        }
      }
    ),
    $("ul", { class: "commands", id: "commands", role: "listbox", "aria-label": "Commands", children: [
      e.map((a, o) => $(
        "li",
        {
          id: `command-${o}`,
          role: "option",
          "aria-selected": o === t,
          "aria-disabled": a.why !== null,
          title: a.why ?? void 0,
          onPointerMove: () => Ye.value = o,
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
var $o = Je([]);
ls("links", (e) => $o.value = e.links);
function bs({ text: e }) {
  let t = So(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, l) => o.map((r, i) => r ? `M${i + 4} ${l + 4}h1v1h-1z` : "").join("")).join("");
  return $("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    h("rect", { width: n, height: n, fill: "#fff" }),
    h("path", { d: a, fill: "#000" })
  ] });
}
function fs() {
  let e = Je(null), t = At(e).current;
  return En(() => {
    Et({ do: "links", what: "list" });
  }, []), $(et, { title: "Share by link", children: [
    h("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    h("ul", { class: "links", children: $o.value.map((n) => $("li", { children: [
      h("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      h("code", { children: n.address }),
      $("span", { class: "buttons", children: [
        h("button", { onClick: () => {
          ns(n.address);
        }, children: "Copy" }),
        h("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        h("button", { onClick: () => Et({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && h(bs, { text: n.address })
    ] }, n.id)) }),
    $("footer", { children: [
      h("button", { onClick: () => Et({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      h("button", { onClick: () => Et({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function vs() {
  let e = At(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    ts({ do: "save", name: n }), Ze.value = null, Vn(`Saving the version “${n}”.`);
  };
  return $(et, { title: "Save a version", children: [
    h("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    $("label", { class: "line", children: [
      h("span", { children: "Name" }),
      h("span", { class: "field", children: h("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    h("footer", { children: h("button", { onClick: t, children: "Save" }) })
  ] });
}
var re = Je(null);
function ys() {
  let e = ss.value?.head, t = At(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    re.value = 0;
    let [o, l] = [Number(n("width")), Number(n("height"))];
    es("picture", { format: n("format"), width: o, height: l, batches: Number(n("batches")) }, (r) => {
      r.url ? (re.value = null, Ln(r.name, r.url), Ze.value = null) : re.value = r.progress ?? 0;
    }, (r) => {
      re.value = null, Vn(r, "warn");
    });
  };
  return $(et, { title: "Save the picture", children: [
    $("div", { ref: t, class: "form", children: [
      $("label", { class: "line", children: [
        h("span", { children: "Format" }),
        $("select", { name: "format", children: [
          h("option", { value: "png", children: "PNG, as it is shown" }),
          h("option", { value: "exr", children: "EXR, the light itself" })
        ] })
      ] }),
      $("label", { class: "line", children: [
        h("span", { children: "Width" }),
        h("input", { type: "number", name: "width", min: 16, max: 16384, value: Math.max(e?.width ?? 0, 640) })
      ] }),
      $("label", { class: "line", children: [
        h("span", { children: "Height" }),
        h("input", { type: "number", name: "height", min: 16, max: 16384, value: Math.max(e?.height ?? 0, 480) })
      ] }),
      $("label", { class: "line", children: [
        h("span", { children: "Batches" }),
        h("input", { type: "number", name: "batches", min: 1, max: 1e5, value: 64 })
      ] })
    ] }),
    re.value !== null && h("progress", { max: 1, value: re.value, "aria-label": "Rendering" }),
    $("footer", { children: [
      h("button", { onClick: () => Co("command"), children: "Copy the command" }),
      h("button", { disabled: re.value !== null, onClick: a, children: re.value === null ? "Render and save" : `${as(re.value * 100)} %` })
    ] })
  ] });
}
function ks() {
  switch (Ze.value) {
    case "help":
      return h(ms, {});
    case "palette":
      return h(gs, {});
    case "share":
      return h(fs, {});
    case "save":
      return h(vs, {});
    case "picture":
      return h(ys, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import {
  act as xs,
  colorText as Lo,
  cost as Ms,
  css as Ss,
  Field as Cs,
  groups as $s,
  hovered as It,
  Icon as Ls,
  lamps as Po,
  output as To,
  penless as Ps,
  pickRow as Ts,
  select as Es,
  selection as Eo,
  switchOn as Vs,
  three as As,
  typeGroupLevel as Is,
  typeLevel as Rs
} from "./desk.js";
import { jsx as Y, jsxs as An } from "./desk.js";
function qs() {
  return An("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    Y("span", {}),
    Y("span", { children: "Name" }),
    Y("span", { children: "Level" }),
    Y("span", { children: "lm" }),
    Y("span", { children: "White" })
  ] });
}
function Fs({ row: e, index: t, count: n }) {
  let a = e.kind === "lamp" ? Po.get(e.id) : void 0, o = e.kind === "group" ? $s.get(e.id) : void 0, l = a ?? o;
  if (!l) return null;
  let r = Eo.value?.kind === e.kind && Eo.value.ids.includes(e.id), i = a ? a.flux * To(a) : (o?.lamps ?? []).reduce((p, c) => {
    let g = Po.get(c);
    return p + (g ? g.flux * To(g) : 0);
  }, 0), u = Ps.value, s = It.value?.kind === e.kind && It.value.id === e.id;
  return An(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${r ? "selected" : ""} ${l.on ? "" : "off"} ${s ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => It.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => It.value = null,
      children: [
        Y("button", { class: "icon power", "aria-pressed": l.on, disabled: u !== null, title: u ?? void 0, "aria-label": `${l.name} on`, onClick: () => Vs(e, !l.on), children: Y(Ls, { name: "power" }) }),
        Y("button", { class: "row-name", "aria-pressed": r, title: a ? Ms(a) : void 0, onClick: (p) => Ts(p, e.kind, e.id), onDblClick: () => xs("frame"), children: Y("span", { children: l.name }) }),
        Y(
          Cs,
          {
            label: `${l.name} level`,
            quantity: "level",
            value: l.level,
            flux: a?.flux,
            step: 0.01,
            disabled: u !== null,
            why: u,
            set: (p) => a ? Rs([e.id], p) : Is(e.id, p)
          }
        ),
        Y("span", { class: "lumens", children: As(i) }),
        a ? An("button", { class: "tint", "aria-label": `${l.name} colour: ${Lo(a)}`, onClick: () => Es("lamp", e.id), children: [
          Y("i", { class: "swatch", style: { background: Ss(a.swatch) } }),
          Lo(a)
        ] }) : Y("span", {})
      ]
    }
  );
}

// src/later/strip.tsx
import {
  act as In,
  command as Fo,
  digits as Rn,
  fade as Rt,
  Field as Hs,
  grids as Vo,
  Icon as qe,
  looks as Ao,
  luxText as me,
  maintenance as Ns,
  meters as Io,
  select as Ro,
  selection as qt,
  signal as Ds,
  status as qn,
  storeLook as Os
} from "./desk.js";
import { Fragment as Us, jsx as x, jsxs as H } from "./desk.js";
var Fn = Ds("looks");
function Ws() {
  return H("section", { class: "looks", "aria-label": "Looks", children: [
    H("header", { children: [
      x("h2", { children: "Looks" }),
      x("button", { class: "tab", onClick: () => Fn.value = "meters", children: "Meters" }),
      x("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: Os, children: x(qe, { name: "plus" }) }),
      x("span", { class: "gap" }),
      H("label", { class: "tint", children: [
        "Fade",
        x(Hs, { label: "Cross-fade", quantity: "seconds", value: Rt.value, step: 0.5, set: (e) => Rt.value = Math.max(0, e(Rt.value)) })
      ] })
    ] }),
    H("ul", { children: [
      Ao.all().map(([e, t], n) => H("li", { class: "look", children: [
        H("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Fo({ do: "look", id: e, what: "recall", seconds: Rt.peek() }), children: [
          t.picture && x("img", { src: t.picture, alt: "" }),
          x("span", { children: t.name })
        ] }),
        x(Gs, { id: e, name: t.name })
      ] }, e)),
      !Ao.ids.value.length && x("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function Gs({ id: e, name: t }) {
  let n = `look-${e}`, a = (i) => {
    let u = i.getBoundingClientRect(), s = document.getElementById(n);
    s?.style.setProperty("left", `${Math.min(u.left, innerWidth - 296)}px`), s?.style.setProperty("bottom", `${innerHeight - u.top + 4}px`), s?.style.setProperty("top", "auto");
  }, o = { popovertarget: n }, l = () => document.getElementById(n)?.hidePopover(), r = (i, u = {}) => {
    l(), Fo({ do: "look", id: e, what: i, ...u });
  };
  return H(Us, { children: [
    x("button", { class: "icon more", ...o, "aria-label": `More of ${t}`, onPointerDown: (i) => a(i.currentTarget), onFocus: (i) => a(i.currentTarget), children: x(qe, { name: "more" }) }),
    H("div", { id: n, popover: "auto", class: "menu", children: [
      H("label", { class: "line", children: [
        x("span", { children: "Name" }),
        x("span", { class: "field", children: x("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (i) => r("rename", { name: i.currentTarget.value }) }) })
      ] }),
      x("button", { class: "item", onClick: () => r("update"), children: x("span", { children: "Update to what is set now" }) }),
      x("button", { class: "item", onClick: () => r("recall", { seconds: 0 }), children: x("span", { children: "Recall at once" }) }),
      x("button", { class: "item", onClick: () => r("remove"), children: x("span", { children: "Remove" }) })
    ] })
  ] });
}
var qo = () => qn.value?.stage === "moving" || qn.value?.stage === "refining" || qn.value?.stage === "loading";
function Ks() {
  let e = Ns.value;
  return H("section", { class: "readings", "aria-label": "Meters and grids", children: [
    H("header", { children: [
      x("h2", { children: "Meters" }),
      x("button", { class: "tab", onClick: () => Fn.value = "looks", children: "Looks" }),
      x("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => In("meter-tool"), children: x(qe, { name: "meter" }) }),
      x("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => In("grid"), children: x(qe, { name: "grid" }) }),
      x("button", { onClick: () => In("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      x("button", { onClick: ko, title: "Save all figures as CSV", children: "CSV" }),
      x("span", { class: "gap" }),
      x("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${Rn(e, 2)} maintained` })
    ] }),
    H("ul", { children: [
      Io.all().map(([t, n]) => {
        let a = n.lux, o = !a || a[1] > 0.02 * a[0] || qo();
        return x("li", { children: H("button", { class: "reading", "aria-pressed": qt.value?.kind === "meter" && qt.value.ids.includes(t), onClick: () => Ro("meter", t), children: [
          H("span", { class: "tint", children: [
            x(qe, { name: "meter" }),
            n.name
          ] }),
          x("strong", { class: o ? "unsettled" : "", children: a ? me(a[0] * e) : "…" }),
          H("small", { children: [
            a ? `±${me(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind,
            n.target ? ` · wants ${me(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      Vo.all().map(([t, n]) => {
        let a = n.target, o = n.mean == null || n.error == null || n.error > 0.05 * n.mean || qo(), l = a && n.mean != null && n.uniformity != null && n.mean * e >= a.lux && n.uniformity >= a.uniformity;
        return x("li", { children: H("button", { class: "reading", "aria-pressed": qt.value?.kind === "grid" && qt.value.ids.includes(t), onClick: () => Ro("grid", t), children: [
          H("span", { class: "tint", children: [
            x(qe, { name: "grid" }),
            n.name,
            " ",
            a && n.mean != null && x("b", { class: l ? "met" : "missed", children: l ? "✓" : "✗" })
          ] }),
          x("strong", { class: o ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${me(n.mean * e)}${n.error == null ? "" : ` ±${me(n.error * e, !1)}`}` }),
          H("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : Rn(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : me(n.min * e, !1),
            " to",
            " ",
            n.max == null ? "…" : me(n.max * e, !1),
            a ? ` · wants ${me(a.lux)}, U₀ ${Rn(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !Io.ids.value.length && !Vo.ids.value.length && x("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Bs() {
  return H("div", { class: "strip-parts", "data-tab": Fn.value, children: [
    x(Ws, {}),
    x(Ks, {})
  ] });
}

// src/later/menus.tsx
import {
  digits as _s,
  display as js,
  Field as Ho,
  go as zs,
  houseLights as Hn,
  Item as we,
  Range as Xs,
  show as Nn,
  theme as No,
  walking as Qs
} from "./desk.js";
import { Fragment as Dn, jsx as P, jsxs as he } from "./desk.js";
function Ys() {
  let e = ct();
  return he(Dn, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((t) => P(we, { id: t }, t)),
    P("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((t) => P(we, { id: `preset-${t}` }, t)),
    P("hr", {}),
    e.length > 0 && P("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    e.map(({ name: t, camera: n }, a) => P("button", { class: "item", onClick: () => zs(n, t), children: P("span", { children: t }) }, a)),
    e.length > 0 && P("hr", {}),
    P(we, { id: "walking", label: Qs.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    P(we, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((t) => P(we, { id: `hands-${t}` }, t))
  ] });
}
var Zs = ["linear", "reinhard", "filmic"];
function Js() {
  let e = js.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return he(Dn, { children: [
    he("fieldset", { children: [
      P("legend", { children: "Tone curve" }),
      P("div", { class: "segments", children: Zs.map((n) => P("button", { "aria-pressed": e.tone === n, onClick: () => Nn({ tone: n }), children: n }, n)) })
    ] }),
    he("fieldset", { children: [
      P("legend", { children: "White balance" }),
      he("label", { class: "line", children: [
        P("span", { children: "White" }),
        P(Ho, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => Nn({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      he("label", { class: "line", children: [
        P("span", { children: "Tint" }),
        P(Ho, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => Nn({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    P("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => P(we, { id: n }, n))
  ] });
}
function eu() {
  return he(Dn, { children: [
    he("label", { class: "line", children: [
      P("span", { children: "House lights" }),
      P(Xs, { label: "House lights", value: Hn.value, text: `${_s(Hn.value * 100)} %`, on: (e) => Hn.value = Math.max(0.3, e) })
    ] }),
    P("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => P("button", { "aria-pressed": No.value === e, onClick: () => No.value = e, children: e }, e)) }),
    P("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => P(we, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as Ft, cut as tu, digits as Do, edit as Oo, go as nu, Icon as tt, Range as au, setCut as ou, signal as lu, storeView as ru, viewName as iu, views as su } from "./desk.js";
import { jsx as W, jsxs as On } from "./desk.js";
var Ht = lu(null);
function uu() {
  let e = su.all();
  return On("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    W("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => Ft("home"), children: W(tt, { name: "home" }) }),
    W("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => Ft("frame"), children: W(tt, { name: "frame" }) }),
    W("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => Ft("back"), children: W(tt, { name: "back" }) }),
    W("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => Ft("forth"), children: W(tt, { name: "forth" }) }),
    W("span", { class: "divide" }),
    e.map(([t, n], a) => Ht.value === t ? W("span", { class: "field", children: W(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (o) => o?.focus(),
        onBlur: (o) => {
          let l = o.currentTarget.value.trim();
          Ht.value = null, l && l !== n.name && Oo(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (o) => {
          o.stopPropagation(), o.key === "Escape" && (o.currentTarget.value = n.name ?? ""), (o.key === "Enter" || o.key === "Escape") && o.currentTarget.blur();
        }
      }
    ) }, t) : On(
      "button",
      {
        class: "saved-view",
        "aria-pressed": iu.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click or F2 renames, Delete removes`,
        onClick: () => nu(n, n.name ?? "view"),
        onDblClick: () => Ht.value = t,
        onKeyDown: (o) => {
          o.key === "F2" && (Ht.value = t), o.key === "Delete" && (o.stopPropagation(), Oo(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          W("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    W("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: ru, children: W(tt, { name: "plus" }) })
  ] });
}
function cu() {
  let e = tu.value;
  if (!e) return null;
  let t = e.height === null ? `${Do(e.value, 2)} m` : `at ${Do(e.height, 2)} m`;
  return On("label", { class: "cut", "data-scroll": !0, children: [
    W("span", { children: "Cut" }),
    W(
      au,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => ou(n * e.most)
      }
    ),
    W("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as pu, useRef as du } from "./desk.js";
import { jsx as Wo } from "./desk.js";
function mu() {
  let e = du(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let l = a.getBoundingClientRect(), r = (s) => Math.max(-1, Math.min(1, s)), i = o ? 0 : r((n.clientX - l.left) / (l.width / 2) - 1), u = o ? 0 : r(1 - (n.clientY - l.top) / (l.height / 2));
    e.current?.style.setProperty("transform", `translate(${i * 28}px, ${-u * 28}px)`), pu(u, i);
  };
  return Wo("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: Wo("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as Go,
  closeWhat as Ko,
  digits as hu,
  hovered as Bo,
  Icon as gu,
  luxText as ge,
  nameOf as bu,
  select as fu,
  useEffect as vu,
  useRef as yu,
  viewSize as ku,
  what as wu
} from "./desk.js";
import { jsx as K, jsxs as ee } from "./desk.js";
var xe = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], xu = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function Mu() {
  let e = wu.value, t = yu(null);
  if (vu(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = ku.value, o = [...e.lamps].sort((c, g) => xe(g) - xe(c)), l = o.reduce((c, g) => c + xe(g), 0) || 1, r = o.slice(0, 9), i = l - r.reduce((c, g) => c + xe(g), 0), u = Math.max(8, Math.min(e.x + 12, n - 332)), s = Math.max(8, Math.min(e.y + 12, a - 120 - 28 * Math.min(o.length, 10))), p = e.lux ? `${ge(e.lux[0])} ±${ge(e.lux[1], !1)}` : "Measuring…";
  return ee(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${u}px`, top: `${s}px` },
      onKeyDown: (c) => {
        c.key === "Escape" && (c.stopPropagation(), Ko(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        ee("header", { children: [
          K("strong", { class: e.done ? "" : "unsettled", children: p }),
          K("span", { class: "quiet", children: "what lights this" }),
          K("button", { class: "icon", "aria-label": "Close", onClick: Ko, children: K(gu, { name: "close" }) })
        ] }),
        ee("ol", { children: [
          r.map((c) => K(
            "li",
            {
              onPointerEnter: () => Bo.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => Bo.value = null,
              children: ee("button", { class: "row", onClick: () => fu("lamp", c.id), children: [
                K("span", { class: "name", children: bu("lamp", c.id) }),
                ee("span", { class: "figure", children: [
                  hu(100 * xe(c) / l, xe(c) / l < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                ee("span", { class: "figure lux", children: [
                  ge(xe(c)),
                  " ±",
                  ge(xu(c), !1)
                ] }),
                ee("span", { class: "bar", "aria-hidden": "true", children: [
                  K("i", { class: "direct", style: { width: `${100 * c.direct[0] / l}%` } }),
                  K("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / l}%` } }),
                  K("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / l}%` } })
                ] }),
                ee("span", { class: "spoken", children: [
                  "direct ",
                  ge(c.direct[0]),
                  ", indirect ",
                  ge(c.indirect[0]),
                  ", caustic",
                  " ",
                  ge(c.caustic[0])
                ] })
              ] })
            },
            c.id
          )),
          o.length > r.length && ee("li", { class: "quiet", children: [
            "and ",
            o.length - r.length,
            " others, ",
            ge(i),
            " together"
          ] }),
          !o.length && K("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        ee("footer", { children: [
          K("span", { class: "key direct", children: "direct" }),
          K("span", { class: "key indirect", children: "indirect" }),
          K("span", { class: "key caustic", children: "caustic" }),
          K("span", { class: "gap" }),
          Go.value.length > 0 && K("button", { onClick: () => Be(Go.peek(), e.hit.point), children: "Aim here" }),
          K("button", { onClick: () => Ue(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Ul as Compare,
  cu as CutBar,
  Lr as Gizmo,
  Ri as Inspector,
  Bi as Legend,
  eu as PageItems,
  Js as SeeingItems,
  qs as SheetHead,
  Fs as SheetRow,
  ks as Sheets,
  Bs as Strip,
  Ys as ViewItems,
  uu as ViewStrip,
  mu as WalkPad,
  Mu as What
};
