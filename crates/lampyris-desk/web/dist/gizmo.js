// src/later/actions.ts
import {
  adding as el,
  ask as tl,
  back as nl,
  candles as jn,
  chosenLamps as ue,
  clearSolo as al,
  command as zn,
  compareHeld as ol,
  copyText as ll,
  deselect as rl,
  each as Xt,
  edit as Qt,
  exposeBy as Xn,
  falseColor as il,
  fine as Qn,
  forth as sl,
  frameSelection as ul,
  go as cl,
  goHome as pl,
  goInside as ml,
  goPreset as dl,
  handles as Yn,
  hands as hl,
  here as bl,
  highlight as gl,
  history as Zn,
  lampMarks as Jn,
  lamps as ut,
  listing as ea,
  lookOnly as ta,
  panels as na,
  PRESETS as fl,
  register as vl,
  say as st,
  scene as yl,
  selection as sa,
  send as kl,
  sheet as _e,
  show as wl,
  soloSelection as xl,
  spot as je,
  startTool as Se,
  stepSelection as aa,
  storeLook as Ml,
  storeView as Sl,
  theme as oa,
  things as la,
  titleOf as ua,
  toggleFalse as Cl,
  toggleWipe as $l,
  travel as ra,
  views as Ll,
  walking as zt,
  whyNot as Z
} from "./desk.js";

// src/later/tools.ts
import {
  add as Ge,
  adding as Ko,
  chosenLamps as Bo,
  cross as Uo,
  distance as _o,
  dot as Dt,
  edit as Ot,
  effect as jo,
  free as Bn,
  grids as Wn,
  lamps as Ke,
  meters as Gn,
  normal as Wt,
  onTool as zo,
  positionOf as Xo,
  say as Gt,
  scale as ge,
  select as Qo,
  step as Kt,
  sub as Bt,
  titleOf as Ut,
  tool as Me,
  up as Un
} from "./desk.js";
var We = null;
jo(() => {
  Me.value !== "grid" && (We = null);
});
function Yo(e) {
  if (!e) return Gt("There is nothing at that point.", "warn");
  switch (Me.peek()) {
    case "aim":
      Be(Bo.peek(), e.point), Me.value = null;
      break;
    case "meter":
      Ue(e.point, e.normal), Me.value = null;
      break;
    case "grid":
      if (!We) {
        We = e;
        return;
      }
      Zo(We.point, e.point), We = null, Me.value = null;
      break;
    case "add":
      Jo(Ko.peek(), e), Me.value = null;
      break;
  }
}
zo(Yo);
function Be(e, t) {
  let n = {};
  for (let a of e) {
    let o = Ke.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: Wt(Bt(t, o.position)) } });
  }
  if (!Object.keys(n).length) return Gt("What is selected shines into all directions: it cannot be aimed.", "warn");
  Ot(`Aim ${Ut(e)}`, { lamps: n });
}
function _t(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let r = o.filter((l) => !n.has(l));
    r.length && (Qo(t, r[r.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), 3e3);
}
function Ue(e, t) {
  let n = Bn(Gn);
  _t(Gn, "meter"), Ot("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function jt(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
function Zo(e, t, n = { lux: 500, uniformity: 0.6 }) {
  let a = Un.peek(), o = Math.abs(a[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], r = Wt(Uo(a, o)), l = Bt(t, e), [i, u] = [Dt(l, o), Dt(l, r)];
  if (Math.abs(i) < 0.05 || Math.abs(u) < 0.05) return Gt("An area needs two corners that lie apart.", "warn");
  let s = Ge(e, Ge(ge(o, Math.min(i, 0)), ge(r, Math.min(u, 0))));
  [i, u] = [Math.abs(i), Math.abs(u)];
  let p = (b) => Math.max(1, Math.ceil(b / jt(Math.max(i, u)))), c = Bn(Wn);
  _t(Wn, "grid"), Ot("Lay a grid", {
    grids: {
      [c]: {
        name: `Area ${c + 1}`,
        corner: s,
        u: ge(o, i),
        v: ge(r, u),
        normal: a,
        columns: p(i),
        rows: p(u),
        target: n
      }
    }
  });
}
var Kn = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function Jo(e, t) {
  let n = Un.peek(), a = Dt(t.normal, n), o = a > 0.7 ? Ge(t.point, ge(n, 1.2)) : Ge(t.point, ge(t.normal, 0.15)), r = a > 0.7 || a < -0.7 ? ge(n, -1) : t.normal, l = { position: o };
  e !== "point" && e !== "sphere" && (l.direction = r), e === "spot" && Object.assign(l, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (l.radius = 0.15), e === "sphere" && (l.radius = 0.08);
  let i = Ke.all().filter(([, u]) => u.own).length;
  _t(Ke, "lamp"), Kt(`Add ${Kn[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${Kn[e] ?? e} ${i + 1}`, kind: e, flux: 800, place: l }
  });
}
function lt(e, t, n) {
  !e.length || t < 1 || Kt(`Copy ${Ut(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function _n(e) {
  e.length && Kt(`Remove ${Ut(e)}`, { do: "remove", lamps: e });
}
function rt(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = Ke.get(o)?.place, l = n.get(o);
    if (!l) continue;
    let i = Ge(l, t), u = r?.aim && _o(r.aim, i) > 1e-6 ? { direction: Wt(Bt(r.aim, i)) } : {};
    a[o] = { place: { position: i, ...u } };
  }
  return { lamps: a };
}
function it(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = Ke.get(n), o = a && Xo(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/actions.ts
var se = () => Z() ?? (ue.value.length ? null : "Select a lamp first.");
function Pl() {
  let e = ue.peek(), t = !e.some((n) => ut.get(n)?.on);
  Qt(`${ua(e)} ${t ? "on" : "off"}`, { lamps: Xt(e, { on: t }) });
}
function Tl() {
  let e = ue.peek(), t = !e.every((n) => ut.get(n)?.parked);
  Qt(`${t ? "Park" : "Unpark"} ${ua(e)}`, { lamps: Xt(e, { parked: t }) });
}
function ia(e) {
  let t = sa.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : la.ids.peek().filter((a) => la.get(a)?.hidden);
  if (!n.length) return st(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Qt(e ? "Hide things" : "Show hidden things", { things: Xt(n, { hidden: e }) });
}
function El() {
  let e = ue.peek()[0], t = ut.get(e)?.place, n = bl();
  if (!t?.position || !t.direction || !n) return st("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  cl({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function Vl() {
  tl("command", {}, (e) => {
    ll(e.text);
  });
}
var Al = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Il = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, Rl = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: ul },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: pl },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: ml },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: nl },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: sl },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Sl, why: Z },
  ...fl.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Il[e],
    keys: `Shift+${t + 1}`,
    run: () => dl(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      zt.value = zt.peek() === "walk" ? "fly" : "walk", st(zt.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: El, why: se },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => aa(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => aa(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => Se("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => sa.value = { kind: "lamp", ids: ut.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: rl },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: Pl, why: se },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: xl, why: () => ue.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: al },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => gl(!0), why: se },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Tl, why: se },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => Se("aim"), why: se },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => je.peek() && Be(ue.peek(), je.peek().point), why: se },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => Yn.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => Yn.value = "turn" },
  ...Al.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: Z,
    run: () => {
      el.value = e, Se("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => lt(ue.peek(), 1, [0.5, 0, 0]), why: se },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => _n(ue.peek()), why: se },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => ia(!0), why: Z },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => ia(!1), why: Z },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => zn({ do: "undo" }), why: () => Z() ?? (Zn.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => zn({ do: "redo" }), why: () => Z() ?? (Zn.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => _e.value = "save", why: Z },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => _e.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Vl },
  { id: "share", group: "Work", label: "Share by link", run: () => _e.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: Cl },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = il();
      wl({ false_color: { ...e, quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => Xn(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => Xn(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => kl({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => ol(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: $l },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: Z, run: () => je.peek() ? Ue(je.peek().point, je.peek().normal) : Se("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => Se("meter"), why: Z },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => Se("grid"), why: Z },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => jn.value = jn.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Ml, why: Z },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => st("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => na.value = !na.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => ea.value = ea.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => ra.value = ra.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => Jn.value = !Jn.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => Qn.value = !Qn.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => oa.value = oa.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => ta.value = !ta.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => hl.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => _e.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => _e.value = "palette" }
];
vl(Rl);
function ct() {
  return [...(yl.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...Ll.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as ql, comparing as Fl, digits as Hl, fitted as Nl, useEffect as Dl, useRef as Ol, viewSize as Wl, wipeAt as Yt } from "./desk.js";
import { Fragment as Kl, jsx as Zt, jsxs as Bl } from "./desk.js";
function Gl() {
  let e = Fl.value, t = ql.value, n = Ol(null);
  if (Dl(() => {
    let s = n.current;
    !s || !t || (s.width = t.picture.width, s.height = t.picture.height, s.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = Wl.value, o = Yt.value, r = Nl(t.picture.width, t.picture.height), l = Math.max(0, Math.min(1, (o * a - r.x) / (t.picture.width * r.scale))), i = (s) => {
    let p = s.currentTarget;
    if (s.stopPropagation(), s.type === "pointerdown") p.setPointerCapture(s.pointerId);
    else if (p.hasPointerCapture(s.pointerId)) {
      let c = p.parentElement.getBoundingClientRect();
      Yt.value = Math.max(0, Math.min(1, (s.clientX - c.left) / c.width));
    }
  }, u = (s) => {
    let p = { ArrowLeft: -0.02, ArrowRight: 0.02 }[s.key];
    p && (s.stopPropagation(), s.preventDefault(), Yt.value = Math.max(0, Math.min(1, o + p)));
  };
  return Bl(Kl, { children: [
    Zt(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * l}% 0 0)` : "none" }
      }
    ),
    Zt("span", { class: "tag left", children: "before" }),
    e === "wipe" && Zt(
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
        "aria-valuetext": `${Hl(o * 100)} % before`,
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
  add as ba,
  chosenLamps as Jl,
  computed as tn,
  editor as er,
  effect as tr,
  fitted as nr,
  Gesture as ar,
  handles as or,
  lamps as mt,
  lookOnly as lr,
  middle as rr,
  nameOf as ir,
  normal as sr,
  pinhole as ur,
  positionOf as fa,
  role as cr,
  selection as pr,
  shown as mr,
  sub as dr,
  things as dt,
  titleOf as hr,
  tool as br,
  turn as ga,
  useEffect as gr,
  useRef as fr,
  viewSize as vr
} from "./desk.js";

// src/later/gizmo.ts
import { project as ca, ray as Ul } from "./desk.js";
import { across as _l, add as te, cross as jl, distance as zl, dot as ce, length as Xl, normal as Jt, scale as ne, sub as Ce } from "./desk.js";
var Ql = "http://www.w3.org/2000/svg", en = 84, fe = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], pt = ["x", "y", "z"], pa = 0.1, Yl = 5 * Math.PI / 180, ma = 48;
function ha(e, t) {
  let n = (d, g, k) => {
    let w = document.createElementNS(Ql, d);
    return w.setAttribute("class", k), g.append(w), w;
  }, a = (d, g, k) => {
    let w = n("g", e, `handle ${d} ${pt[g] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), r = fe.map((d, g) => a("ring", g, `ring-${pt[g]}`)), l = fe.map((d, g) => a("plane", g, `plane-${pt[g]}`)), i = fe.map((d, g) => a("arrow", g, `move-${pt[g]}`)), u = a("centre", -1, "move-view"), s = a("aim", -1, "aim"), p = n("text", e, "handle-text"), c = (d, g) => {
    let [k, w, T] = ca(d.hole, g);
    return T < 0.02 && !d.hole.parallel ? null : [d.fit.x + k * d.fit.scale, d.fit.y + w * d.fit.scale];
  }, b = (d, g) => {
    let k = ca(d.hole, g)[2];
    return en / d.fit.scale * d.hole.pixel * (d.hole.parallel ? 1 : Math.max(k, 0.02));
  }, m = (d, g, k = !1) => {
    let w = g.filter((S) => S !== null), T = w.length < g.length || w.length < 2 ? "" : `M${w.map((S) => `${S[0].toFixed(1)} ${S[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    d.setAttribute("d", T);
  }, f = (d, g, k) => {
    d.setAttribute("d", g ? `M${g[0] - k} ${g[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, v = (d, g) => d.forEach((k) => k.group.classList.toggle("gone", !g));
  function V(d, g) {
    let k = d.position, w = c(g, k), T = b(g, k), S = d.mode === "move";
    v([...i, ...l, u], S && w !== null), v(r, !S && w !== null && d.turns);
    let j = d.aim ?? (d.direction ? te(k, ne(d.direction, 3 * T)) : null);
    if (v([s], j !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    fe.forEach((O, B) => {
      let I = c(g, te(k, ne(O, T))), nt = I ? Math.hypot(I[0] - w[0], I[1] - w[1]) < 12 : !0;
      if (i[B].group.classList.toggle("gone", !S || nt), I && S) {
        let [be, De] = [(I[0] - w[0]) / en, (I[1] - w[1]) / en], ot = Math.hypot(be, De) || 1, [ie, Oe] = [be / ot, De / ot], Nt = [w[0] + 14 * ie, w[1] + 14 * Oe];
        m(i[B].hit, [Nt, I]), i[B].seen.setAttribute("d", `M${Nt[0].toFixed(1)} ${Nt[1].toFixed(1)}L${I[0].toFixed(1)} ${I[1].toFixed(1)}M${(I[0] - 9 * ie - 4.5 * Oe).toFixed(1)} ${(I[1] - 9 * Oe + 4.5 * ie).toFixed(1)}L${I[0].toFixed(1)} ${I[1].toFixed(1)}L${(I[0] - 9 * ie + 4.5 * Oe).toFixed(1)} ${(I[1] - 9 * Oe - 4.5 * ie).toFixed(1)}`);
      }
      let [He, Ne] = [fe[(B + 1) % 3], fe[(B + 2) % 3]], Y = Math.abs(ce(O, g.hole.parallel ? g.hole.forward : Jt(Ce(k, g.hole.eye)))) < 0.15;
      l[B].group.classList.toggle("gone", !S || Y);
      let at = (be, De) => c(g, te(k, te(ne(He, be * T), ne(Ne, De * T)))), On = [at(0.3, 0.3), at(0.5, 0.3), at(0.5, 0.5), at(0.3, 0.5)];
      if (m(l[B].hit, On, !0), m(l[B].seen, On, !0), !S) {
        let be = Array.from({ length: ma + 1 }, (De, ot) => {
          let ie = 2 * Math.PI * ot / ma;
          return c(g, te(k, te(ne(He, Math.cos(ie) * T), ne(Ne, Math.sin(ie) * T))));
        });
        m(r[B].hit, be), m(r[B].seen, be);
      }
    }), f(u.hit, w, 13), f(u.seen, w, 7);
    let A = j && c(g, j);
    m(o, [w, A]), f(s.hit, A, 16), s.seen.setAttribute("d", A ? `M${A[0] - 8} ${A[1]}h16M${A[0]} ${A[1] - 8}v16M${A[0] - 5} ${A[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let K = t.effect(() => {
    let d = t.target.value, g = t.view.value;
    e.classList.toggle("empty", !d || !g), d && g && V(d, g);
  }), Hn = (d, g, k) => Ul(d.hole, (g.clientX - k.left - d.fit.x) / d.fit.scale, (g.clientY - k.top - d.fit.y) / d.fit.scale);
  function Fe(d, g, k) {
    d.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let T = t.view.peek();
      if (!T || !t.target.peek()) return;
      let S = e.getBoundingClientRect(), j = k(T), A = t.hold(g), O = Hn(T, w, S);
      j(O, !1, { ...A, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), d.setPointerCapture(w.pointerId), d.classList.add("held");
      let B = (Y) => {
        p.textContent = j(Hn(T, Y, S), Y.ctrlKey || Y.metaKey, A), p.setAttribute("x", String(Y.clientX - S.left + 16)), p.setAttribute("y", String(Y.clientY - S.top - 12));
      }, I = (Y) => {
        d.removeEventListener("pointermove", B), d.removeEventListener("pointerup", nt), d.removeEventListener("pointercancel", He), removeEventListener("keydown", Ne, !0), d.classList.remove("held"), p.textContent = "", Y ? A.end() : A.cancel();
      }, nt = () => I(!0), He = () => I(!1), Ne = (Y) => {
        Y.key === "Escape" && (Y.stopPropagation(), I(!1));
      };
      d.addEventListener("pointermove", B), d.addEventListener("pointerup", nt), d.addEventListener("pointercancel", He), addEventListener("keydown", Ne, !0);
    });
  }
  let Ft = (d, g, k) => k ? Math.round(d / g) * g : d, Ht = (d) => d.map((g) => g.toFixed(2)).join("  ") + " m";
  fe.forEach((d, g) => {
    Fe(i[g].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (T, S, j) => {
        let A = Zl(k, d, T);
        w ??= A;
        let O = ne(d, Ft(A - w, pa, S));
        return j.move(O), Ht(O);
      };
    }), Fe(l[g].group, "move", () => Nn(d)), Fe(r[g].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (T, S, j) => {
        let A = da(k.position, d, T), O = A && Jt(Ce(A, k.position), _l(d));
        if (!O) return "";
        w.at ??= O;
        let B = Math.atan2(ce(d, jl(w.at, O)), ce(w.at, O)), I = Ft(B, Yl, S);
        return j.rotate(d, I), `${(I * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), Fe(u.group, "move", (d) => Nn(d.hole.forward)), Fe(s.group, "aim", (d) => {
    let g = t.target.peek(), k = g.aim ?? te(g.position, ne(g.direction, 3 * b(d, g.position))), w = Dn(k, d.hole.forward);
    return (T, S, j) => {
      let A = w(T, S), O = te(k, A);
      return zl(O, g.position) > 1e-3 && j.turn(Jt(Ce(O, g.position)), O), Ht(O);
    };
  });
  function Nn(d) {
    let g = Dn(t.target.peek().position, d);
    return (k, w, T) => {
      let S = g(k, w);
      return T.move(S), Ht(S);
    };
  }
  function Dn(d, g) {
    let k = null;
    return (w, T) => {
      let S = da(d, g, w);
      return S ? (k ??= S, Ce(S, k).map((j) => Ft(j, pa, T))) : [0, 0, 0];
    };
  }
  return { stop: K };
}
function Zl(e, t, n) {
  let a = Ce(e, n.origin), o = ce(t, n.direction), r = 1 - o * o;
  return r < 1e-6 ? 0 : (o * ce(n.direction, a) - ce(t, a)) / r;
}
function da(e, t, n) {
  let a = ce(t, n.direction);
  if (Math.abs(a) < 1e-4 * Xl(t)) return null;
  let o = ce(Ce(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : te(n.origin, ne(n.direction, o));
}

// src/later/handles.tsx
import { jsx as Cr } from "./desk.js";
function yr([e, t, n, a], [o, r, l, i]) {
  return [
    a * o + e * i + t * l - n * r,
    a * r - e * l + t * i + n * o,
    a * l + e * r - t * o + n * i,
    a * i - e * o - t * r - n * l
  ];
}
var kr = () => !lr.value && cr.value !== "watch" && er.value.you && br.value !== "aim", va = tn(() => {
  let e = pr.value;
  if (!e || !kr()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => dt.get(a) && !dt.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = Jl.value.filter((n) => fa(mt.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), ya = (e) => {
  let t = dt.get(e);
  return t?.place?.position ?? (t?.box ? rr(t.box) : null);
}, wr = tn(() => {
  let e = va.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? fa(mt.get(t)) : ya(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? mt.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: or.value
  };
}), xr = tn(() => {
  let e = mr.value;
  if (vr.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: ur(e.camera, t, n), fit: nr(t, n) };
}), Mr = {
  effect: tr,
  target: wr,
  view: xr,
  hold(e) {
    let t = va.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? hr(n) : n.length === 1 ? ir("thing", n[0]) : `${n.length} things`, r = new ar(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), l = a === "lamps" ? it(n) : new Map(n.map((s) => [s, ya(s)])), i = new Map(n.map((s) => [s, (a === "lamps" ? mt : dt).get(s)?.place])), u = (s) => {
      let p = n.map((c) => [c, s(c)]).filter(([, c]) => c);
      r.set({ [a]: Object.fromEntries(p.map(([c, b]) => [c, { place: b }])) });
    };
    return {
      move: (s) => a === "lamps" ? r.set(rt(n, s, l)) : u((p) => ({ position: ba(l.get(p), s) })),
      turn: (s, p) => u((c) => i.get(c)?.direction ? { direction: s, ...p ? { aim: p } : {} } : null),
      rotate: (s, p) => u((c) => {
        let b = i.get(c);
        if (b?.direction) {
          let v = sr(ga(b.direction, s, p)), V = b.aim && b.position ? ga(dr(b.aim, b.position), s, p) : null;
          return { direction: v, ...V ? { aim: ba(b.position, V) } : {} };
        }
        let m = Math.sin(p / 2), f = [s[0] * m, s[1] * m, s[2] * m, Math.cos(p / 2)];
        return { rotation: yr(f, b?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => r.end(),
      cancel: () => r.cancel()
    };
  }
};
function Sr() {
  let e = fr(null);
  return gr(() => ha(e.current, Mr).stop, []), Cr("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as co, deselect as Li, Icon as wn, selection as Pi, signal as Ti } from "./desk.js";

// src/later/measure.tsx
import {
  deselect as xa,
  digits as Pe,
  edit as bt,
  grids as Vr,
  Icon as Ma,
  length as Te,
  luxText as Ee,
  maintenance as nn,
  meters as Ar,
  selection as Sa
} from "./desk.js";

// src/later/parts.tsx
import { Field as ka, Gesture as $r, Range as Lr, stroke as Pr, useRef as Tr } from "./desk.js";
import { jsx as ae, jsxs as ht } from "./desk.js";
function R({ title: e, note: t, children: n }) {
  return ht("section", { class: "part", "aria-label": e, children: [
    ht("h3", { children: [
      e,
      t && ae("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function W(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function q(e) {
  return ht("label", { class: "line", children: [
    ae("span", { children: e.label }),
    ae(ka, { ...e, label: e.name ?? e.label })
  ] });
}
function Er(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function J({ label: e, names: t, quantity: n, value: a, set: o, step: r, disabled: l }) {
  let i = t ?? ["X", "Y", "Z"];
  return ht("div", { class: "line", role: "group", "aria-label": e, children: [
    ae("span", { children: e }),
    ae("span", { class: "triple", children: i.map((u, s) => ae(
      ka,
      {
        label: `${e} ${u}`,
        quantity: n,
        value: a[s],
        text: Er(a[s], n),
        step: r,
        disabled: l,
        set: (p) => o(s, p)
      },
      u
    )) })
  ] });
}
function $e({ label: e, name: t, value: n, text: a, patch: o, reset: r, notch: l, class: i, style: u, disabled: s }) {
  let p = Tr(null), c = (m) => () => {
    p.current?.[m](), p.current = null;
  }, b = (m) => p.current ? p.current.set(o(m)) : Pr(e + t, t, o(m));
  return ae(
    Lr,
    {
      label: e,
      value: n,
      text: a,
      notch: l,
      class: i,
      gradient: u,
      disabled: s,
      begin: () => p.current = new $r(t),
      on: b,
      end: c("end"),
      cancel: c("cancel"),
      reset: r === void 0 ? void 0 : () => b(r)
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
import { Fragment as an, jsx as L, jsxs as U } from "./desk.js";
var Ir = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function Ca() {
  let e = Sa.value?.ids[0], t = Ar.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: r, ...l } = { ...t, ...o };
    bt(`${t.name}: ${a}`, { meters: { [e]: l } });
  };
  return U(an, { children: [
    L("header", { class: "panel-head", children: L(Le, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    L("p", { class: "crumbs", children: t.lux ? `${Ee(t.lux[0] * nn.value)} ±${Ee(t.lux[1] * nn.value, !1)}` : "measuring" }),
    L("div", { class: "scroll", children: U(R, { title: "Meter", children: [
      U("label", { class: "line", children: [
        L("span", { children: "Measures" }),
        L("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: Ir.map(([a, o]) => L("option", { value: a, children: o }, a)) })
      ] }),
      L(J, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: oe(t.point, a, o) }) }),
      L(J, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: oe(t.normal, a, o) }) }),
      U("button", { class: "plain full", onClick: () => {
        xa(), bt(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        L(Ma, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var wa = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function $a() {
  let e = Sa.value?.ids[0], t = Vr.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This grid is gone." });
  let n = nn.value, a = (i, u) => {
    let { name: s, corner: p, u: c, v: b, normal: m, columns: f, rows: v, target: V } = { ...t, ...u };
    bt(`${t.name}: ${i}`, { grids: { [e]: { name: s, corner: p, u: c, v: b, normal: m, columns: f, rows: v, target: V } } });
  }, o = () => {
    let i = jt(Math.max(Te(t.u), Te(t.v)));
    a("standard spacing", { columns: Math.max(1, Math.ceil(Te(t.u) / i)), rows: Math.max(1, Math.ceil(Te(t.v) / i)) });
  }, r = (i, u, s) => U(an, { children: [
    L("dt", { children: i }),
    L("dd", { children: u == null ? "…" : s(u) })
  ] }), l = t.target ?? { lux: 500, uniformity: 0.6 };
  return U(an, { children: [
    L("header", { class: "panel-head", children: L(Le, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    U("p", { class: "crumbs", children: [
      Pe(Te(t.u), 2),
      " × ",
      Pe(Te(t.v), 2),
      " m, ",
      Pe(t.columns * t.rows),
      " points"
    ] }),
    U("div", { class: "scroll", children: [
      L(R, { title: "Figures", note: n === 1 ? "new" : `× ${Pe(n, 2)}`, children: U("dl", { class: "figures", children: [
        r("Ē", t.mean, (i) => Ee(i * n)),
        r("E min", t.min, (i) => Ee(i * n)),
        r("E max", t.max, (i) => Ee(i * n)),
        r("U₀ = min / mean", t.uniformity, (i) => Pe(i, 2)),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => Pe(i, 2)),
        r("± of Ē", t.error, (i) => Ee(i * n))
      ] }) }),
      U(R, { title: "Target", children: [
        U("label", { class: "line", children: [
          L("span", { children: "Class" }),
          U("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let u = wa[Number(i.currentTarget.value)];
            a("target", { target: u ? { lux: u[1], uniformity: u[2] } : null });
          }, children: [
            L("option", { value: "", children: t.target ? "choose…" : "none" }),
            wa.map(([i, u, s], p) => U("option", { value: p, children: [
              i,
              ": ",
              u,
              " lx, U₀ ",
              s
            ] }, i)),
            L("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        L(q, { label: "Ē at least", quantity: "lux", step: 50, value: l.lux, set: (i) => a("target", { target: { ...l, lux: i(l.lux) } }) }),
        L(q, { label: "U₀ at least", quantity: "share", step: 0.05, value: l.uniformity, set: (i) => a("target", { target: { ...l, uniformity: i(l.uniformity) } }) })
      ] }),
      U(R, { title: "Area", children: [
        L(J, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, u) => a("move", { corner: oe(t.corner, i, u) }) }),
        L(q, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        L(q, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        L("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: o, children: "Spacing of the standard" }),
        U("button", { class: "plain full", onClick: () => {
          xa(), bt(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          L(Ma, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as ye,
  chosenLamps as jr,
  dot as un,
  edit as vt,
  format as Ha,
  groups as yt,
  handles as gt,
  Icon as Ae,
  lamps as dn,
  layers as zr,
  normal as Na,
  output as Da,
  percent as mn,
  positionOf as Va,
  selection as cn,
  signal as Oa,
  spot as Xr,
  sub as Aa,
  titleOf as hn,
  tool as Qr,
  toLevel as Ia,
  toTravel as Yr,
  typeLevel as pn,
  up as Zr,
  Fade as Jr,
  Field as ei,
  wantLevel as Ra,
  compass as Wa,
  add as kt,
  scale as Ie,
  length as ti,
  Range as ni,
  strokeLevel as qa,
  useRef as ai
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as Hr,
  digits as Pa,
  edit as Nr,
  fromHex as Dr,
  hex as Or,
  lamps as Ta,
  mired as ve,
  titleOf as Wr
} from "./desk.js";

// src/later/white.ts
import { css as Rr, mired as on } from "./desk.js";
function qr(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((r) => Math.max(0, r));
}
function Fr(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function La(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, r) => {
    let l = on(e) + (on(t) - on(e)) * r / (n - 1);
    return Rr(qr(...Fr(1e6 / l)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as rn, jsx as H, jsxs as pe } from "./desk.js";
var ze = 1800, sn = 1e4, Gr = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], Kr = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], Br = La(ze, sn), ln = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(Ta.get(n).color) }]))
}), Ur = (e) => {
  let t = 1e6 / (ve(ze) + (ve(sn) - ve(ze)) * e);
  return Math.round(t / 10) * 10;
}, _r = (e) => (ve(e) - ve(ze)) / (ve(sn) - ve(ze));
function Ea() {
  let e = Hr.value, t = e.map((l) => Ta.get(l)?.color).filter((l) => l !== void 0);
  if (!t.length) return null;
  let n = W(t.map((l) => l.mode)), a = t[0], o = Wr(e), r = (l, i) => Nr(`${o}: ${l}`, ln(e, i));
  return pe(rn, { children: [
    pe("div", { class: "line", children: [
      H("span", { children: "Colour" }),
      H("div", { class: "segments", role: "group", "aria-label": "Colour by", children: Kr.map(([l, i]) => H("button", { "aria-pressed": n === l, onClick: () => r(`colour by ${i}`, () => ({ mode: l })), children: i }, l)) })
    ] }),
    n === "kelvin" && pe(rn, { children: [
      pe("div", { class: "line slide", children: [
        H("span", { children: "White" }),
        H(
          $e,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: Br,
            value: _r(a.kelvin),
            text: `${Pa(a.kelvin)} kelvin`,
            patch: (l) => ln(e, () => ({ mode: "kelvin", kelvin: Ur(l) }))
          }
        )
      ] }),
      H(
        q,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: W(t.map((l) => l.kelvin)),
          step: 50,
          set: (l) => r("white", (i) => ({ mode: "kelvin", kelvin: l(i.kelvin) }))
        }
      ),
      H("div", { class: "whites", role: "group", "aria-label": "Whites", children: Gr.map(([l, i]) => H("button", { title: i, "aria-label": `${l} kelvin, ${i}`, onClick: () => r(`${l} K`, () => ({ mode: "kelvin", kelvin: l })), children: l }, l)) }),
      pe("div", { class: "line slide", children: [
        H("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        H(
          $e,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${Pa(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (l) => ln(e, () => ({ tint: Math.round((l * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      H(q, { label: "", name: "Tint, typed", quantity: "number", value: W(t.map((l) => l.tint)), step: 1, set: (l) => r("tint", (i) => ({ tint: Math.max(-50, Math.min(50, l(i.tint))) })) })
    ] }),
    n === "rgb" && pe(rn, { children: [
      pe("label", { class: "line", children: [
        H("span", { children: "Colour" }),
        H("input", { type: "color", class: "pick", "aria-label": "Colour", value: Or(a.rgb), onChange: (l) => r("colour", () => ({ mode: "rgb", rgb: Dr(l.currentTarget.value) })) })
      ] }),
      H(
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
    n === "xy" && pe("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      H("span", { children: "x, y" }),
      H("span", { class: "triple", children: [0, 1].map((l) => H(
        q,
        {
          label: "xy"[l],
          quantity: "number",
          step: 1e-3,
          value: W(t.map((i) => i.xy[l])),
          set: (i) => r("chromaticity", (u) => ({ xy: u.xy.map((s, p) => p === l ? Math.max(0.01, Math.min(0.9, i(s))) : s) }))
        },
        l
      )) })
    ] }),
    n === null && H("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as bn, jsx as y, jsxs as N } from "./desk.js";
var Ve = Oa(1), ft = Oa([1, 0, 0]), oi = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], wt = 180 / Math.PI;
function Fa(e, t) {
  let { right: n, ahead: a } = Wa(t), o = -un(e, t);
  return [Math.atan2(un(e, n), un(e, a)) * wt, Math.asin(Math.max(-1, Math.min(1, o))) * wt];
}
function li(e, t, n) {
  let { right: a, ahead: o } = Wa(n), [r, l] = [e / wt, t / wt], i = kt(Ie(a, Math.sin(r)), Ie(o, Math.cos(r)));
  return Na(kt(Ie(i, Math.cos(l)), Ie(n, -Math.sin(l))));
}
function ri({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction);
  return N("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    N("button", { "aria-pressed": Qr.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => ye("aim"), children: [
      y(Ae, { name: "aim" }),
      "Aim"
    ] }),
    y("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => ye("solo"), children: y(Ae, { name: "solo" }) }),
    y("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => ye("from-lamp"), children: y(Ae, { name: "eye" }) }),
    y("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => ye("frame"), children: y(Ae, { name: "frame" }) }),
    y("span", { class: "gap" }),
    y("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => ye("park"), children: "Park" }),
    y("button", { class: "icon", "aria-label": `Remove ${hn(e)}`, title: "Remove (Del)", onClick: () => ye("remove"), children: y(Ae, { name: "bin" }) })
  ] });
}
function ii({ ids: e, all: t }) {
  let n = W(t.map((l) => l.level)), a = t.reduce((l, i) => l + i.flux * Da(i), 0), o = t.every((l) => l.free), r = e[e.length - 1];
  return N(R, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    N("div", { class: "line slide", children: [
      y("span", { children: "Level" }),
      y(si, { id: r })
    ] }),
    N("label", { class: "line", children: [
      y("span", {}),
      y(
        ei,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: W(t.map((l) => l.flux)) ?? void 0,
          step: 0.01,
          set: (l) => pn(e, l),
          open: Ra.value,
          opened: () => Ra.value = "",
          id: "level"
        }
      )
    ] }),
    y(
      q,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (l) => pn(e, (i, u) => l(i * u) / u)
      }
    ),
    N("div", { class: "line", children: [
      y("span", { children: "Stops" }),
      y("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: oi.map(([l, i]) => y("button", { "aria-label": `${i} stop`, onClick: () => pn(e, (u) => Math.min(1e3, u * 2 ** l)), children: i }, i)) })
    ] }),
    N("p", { class: "sum", children: [
      Ha(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (yt.get(t[0].group)?.level ?? 1) !== 1 && ` (${mn(t[0].level)} % × ${mn(yt.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    y(Ea, {})
  ] });
}
function si({ id: e }) {
  let t = ai(null), n = dn.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (r) => () => {
    t.current?.[r](), t.current = null;
  };
  return y(
    ni,
    {
      label: "Level",
      value: Yr(n.level),
      text: `${mn(n.level)} %, ${Ha(n.flux * Da(n), "flux")}`,
      begin: () => t.current = new Jr(a),
      on: (r) => t.current ? t.current.to(Ia(r)) : qa(a, Ia(r)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => qa(a, 1)
    }
  );
}
function Xe(e, t, n) {
  let a = {};
  for (let o of e) {
    let r = dn.get(o), l = n(r.place ?? {}, r);
    l && (a[o] = { place: l });
  }
  Object.keys(a).length && vt(`${hn(e)}: ${t}`, { lamps: a });
}
function ui({ ids: e, all: t }) {
  let n = (o) => W(t.map((r) => r.place?.[o] ?? null)), a = (o) => t.some((r) => r.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : N(R, { title: "Beam", note: "re-trace", children: [
    a("outer") && N(bn, { children: [
      y(q, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => Xe(e, "beam", (r) => r.outer == null ? null : { inner: Math.max(0.1, Math.min(r.outer, o(r.inner ?? r.outer))) }) }),
      y(q, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => Xe(e, "beam", (r) => {
        if (r.outer == null) return null;
        let l = Math.max(0.2, Math.min(179, o(r.outer)));
        return { outer: l, inner: Math.min(r.inner ?? l, l) };
      }) })
    ] }),
    a("radius") && y(q, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => Xe(e, "radius", (r) => r.radius == null ? null : { radius: Math.max(1e-3, o(r.radius)) }) })
  ] });
}
function ci({ ids: e, all: t }) {
  let n = t.filter((c) => Va(c) !== null);
  if (!n.length) return null;
  let a = n.map((c) => Va(c)), o = (c, b) => W(b.map((m) => Math.round(m[c] * 1e4) / 1e4)), r = t.filter((c) => c.place?.direction), l = Zr.value, i = r.map((c) => Fa(c.place?.direction, l).map((b) => Math.round(b * 10) / 10)), u = t.map((c) => c.place?.aim).filter((c) => !!c), s = (c, b) => {
    let m = it(e), f = {};
    for (let [v, V] of m) {
      let K = [0, 0, 0];
      K[c] = b(V[c]) - V[c], Object.assign(f, rt([v], K, m).lamps);
    }
    vt(`Move ${hn(e)}`, { lamps: f });
  }, p = (c, b) => Xe(e, c ? "tilt" : "pan", (m) => {
    if (!m.direction) return null;
    let f = Fa(m.direction, l);
    f[c] = b(f[c]);
    let v = li(f[0], Math.max(-90, Math.min(90, f[1])), l), V = m.aim && m.position ? ti(Aa(m.aim, m.position)) : 0;
    return { direction: v, ...V && m.position ? { aim: kt(m.position, Ie(v, V)) } : {} };
  });
  return N(R, { title: "Place", note: "re-trace", children: [
    y(J, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => o(c, a)), set: s }),
    r.length > 0 && N(bn, { children: [
      y(q, { label: "Pan", quantity: "angle", step: 1, value: W(i.map((c) => c[0])), set: (c) => p(0, c) }),
      y(q, { label: "Tilt", quantity: "angle", step: 1, value: W(i.map((c) => c[1])), set: (c) => p(1, c) }),
      y(
        J,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: u.length ? [0, 1, 2].map((c) => o(c, u)) : [NaN, NaN, NaN],
          set: (c, b) => Xe(e, "aim", (m) => {
            if (!m.direction || !m.position) return null;
            let f = oe(m.aim ?? kt(m.position, Ie(m.direction, 2)), c, b);
            return { aim: f, direction: Na(Aa(f, m.position)) };
          })
        }
      )
    ] }),
    N("div", { class: "line", children: [
      y("span", { children: "Handles" }),
      N("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        y("button", { "aria-pressed": gt.value === "move", onClick: () => gt.value = "move", children: "Move" }),
        y("button", { "aria-pressed": gt.value === "turn", onClick: () => gt.value = "turn", children: "Turn" })
      ] })
    ] }),
    r.length > 0 && Xr.value && y("button", { class: "plain full", onClick: () => ye("aim-here"), children: "Aim at the last point" })
  ] });
}
function pi({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : N(R, { title: "Copies along a line", children: [
    y(q, { label: "How many", quantity: "number", step: 1, value: Ve.value, set: (n) => Ve.value = Math.max(1, Math.min(100, Math.round(n(Ve.value)))) }),
    y(J, { label: "Step", quantity: "length", step: 0.05, value: ft.value, set: (n, a) => ft.value = oe(ft.value, n, a) }),
    N("button", { class: "plain full", onClick: () => lt(e, Ve.value, ft.value), children: [
      y(Ae, { name: "copy" }),
      Ve.value === 1 ? "One copy" : `${Ve.value} copies`
    ] })
  ] });
}
function Ga() {
  let e = jr.value, t = e.map((l) => dn.get(l)).filter((l) => !!l);
  if (!t.length) return y("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && yt.get(n.group), o = cn.value?.kind === "group" ? yt.get(cn.value.ids[0]) : void 0, r = n?.layer != null ? zr.value[n.layer] : void 0;
  return N(bn, { children: [
    y("header", { class: "panel-head", children: n ? y(Le, { label: "Name of the lamp", value: n.name, set: (l) => vt(`Rename ${n.name}`, { lamps: { [e[0]]: { name: l } } }) }) : o ? y(Le, { label: "Name of the group", value: o.name, set: (l) => vt(`Rename ${o.name}`, { groups: { [cn.value.ids[0]]: { name: l } } }) }) : N("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    y("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((l) => l.on).length} of ${t.length} on` }),
    N("div", { class: "scroll", children: [
      y(ri, { ids: e, all: t }),
      y(ii, { ids: e, all: t }),
      y(R, { title: "Photometry", children: y("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      y(ui, { ids: e, all: t }),
      y(ci, { ids: e, all: t }),
      y(pi, { ids: e, all: t }),
      y("p", { class: "cost", children: t.every((l) => l.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as gn,
  candles as xt,
  command as mi,
  digits as St,
  edit as Ka,
  Field as di,
  filterOf as ja,
  go as hi,
  history as bi,
  hovered as Ba,
  Icon as Ct,
  layers as gi,
  lookOnly as Ua,
  maintenance as Re,
  materials as fi,
  percent as vi,
  scene as yi,
  select as za,
  signal as ki,
  singleKeys as _a,
  sub as wi,
  things as xi,
  travel as Mt,
  Virtual as Xa
} from "./desk.js";
import { Fragment as Mi, jsx as x, jsxs as E } from "./desk.js";
function Qa() {
  let e = yi.value;
  if (!e) return null;
  let t = wi(e.bounds[1], e.bounds[0]);
  return E(Mi, { children: [
    E(R, { title: "Room", children: [
      E("p", { children: [
        t.map((n) => St(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${St(e.triangles)} triangles` : ""
      ] }),
      x("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && x("ul", { class: "buttons", children: e.cameras.map((n, a) => x("li", { children: x("button", { onClick: () => hi(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && E("details", { children: [
        E("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        x("ul", { class: "remarks", children: e.warnings.map((n) => x("li", { children: n }, n)) })
      ] })
    ] }),
    E(R, { title: "Figures", children: [
      E("label", { class: "line", children: [
        x("span", { children: "Maintenance" }),
        x(di, { label: "Maintenance factor", quantity: "share", value: Re.value, step: 0.05, set: (n) => Re.value = Math.max(0.1, Math.min(1, n(Re.value))) })
      ] }),
      E("p", { class: "quiet", children: [
        Re.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Re.value === 1 && x("button", { class: "plain", onClick: () => Re.value = 0.8, children: "0.80" })
      ] }),
      E("div", { class: "line", children: [
        x("span", { children: "Unit" }),
        E("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          x("button", { "aria-pressed": xt.value === "lx", onClick: () => xt.value = "lx", children: "lx, cd/m²" }),
          x("button", { "aria-pressed": xt.value === "fc", onClick: () => xt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    x(R, { title: "Layers of light", children: x("ul", { class: "layers", children: gi.value.map((n, a) => E("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      x("i", { class: "dot", "aria-hidden": "true" }),
      x("span", { children: n.name || `layer ${a + 1}` }),
      x("small", { children: n.held ? "held" : vi(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    E(R, { title: "Hands", children: [
      E("div", { class: "line", children: [
        x("span", { children: "Faders" }),
        E("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          x("button", { "aria-pressed": Mt.value === "square", onClick: () => Mt.value = "square", children: "Square law" }),
          x("button", { "aria-pressed": Mt.value === "linear", onClick: () => Mt.value = "linear", children: "Even" })
        ] })
      ] }),
      E("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: _a.value, onChange: (n) => _a.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      E("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: Ua.value, onChange: (n) => Ua.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var $t = ki("");
function Ya({ label: e }) {
  return x("span", { class: "field filter", children: x("input", { type: "text", "aria-label": e, placeholder: "Filter", value: $t.value, onInput: (t) => $t.value = t.currentTarget.value }) });
}
function Za() {
  let e = ja(xi, $t.value);
  return E("div", { class: "listing", children: [
    x(Ya, { label: "Filter things" }),
    x(
      Xa,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => Ba.value = { kind: "thing", id: n }, onPointerLeave: () => Ba.value = null, children: [
            x("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => Ka(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: x(Ct, { name: a.hidden ? "eye-off" : "eye" }) }),
            x("button", { class: "row-name", onClick: () => za("thing", n), children: x("span", { children: a.name }) }),
            x("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => Ka(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: x(Ct, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function Ja() {
  let e = ja(fi, $t.value);
  return E("div", { class: "listing", children: [
    x(Ya, { label: "Filter materials" }),
    x(
      Xa,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row material", role: "listitem", children: [
            x("button", { class: "row-name", onClick: () => za("material", n), children: x("span", { children: a.name }) }),
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
function eo() {
  let e = bi.value;
  return E(R, { title: "History", children: [
    E("p", { children: [
      e.steps === 1 ? "One step" : `${St(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => gn("undo"), children: [
      x(Ct, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => gn("redo"), children: [
      x(Ct, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    x("button", { class: "plain full", onClick: () => gn("save"), children: "Save a version with a name…" }),
    x("button", { class: "plain full", onClick: () => mi({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as fn,
  edit as oo,
  fromHex as Si,
  hex as Ci,
  Icon as to,
  materials as lo,
  middle as no,
  select as ro,
  selection as io,
  things as vn
} from "./desk.js";
import { Fragment as kn, jsx as C, jsxs as z } from "./desk.js";
var yn = 180 / Math.PI;
function ao(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * yn : 0;
}
function $i(e, t) {
  let n = [0, 0, 0, Math.cos(t / yn / 2)];
  return n[e] = Math.sin(t / yn / 2), n;
}
function so() {
  let e = (io.value?.ids ?? []).filter((u) => vn.get(u)), t = e.map((u) => vn.get(u));
  if (!t.length) return C("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((u) => u.locked), r = (u, s) => oo(`${a}: ${u}`, { things: Object.fromEntries(e.map((p, c) => [p, s(t[c])])) }), l = t.map((u) => u.place?.position ?? (u.box ? no(u.box) : [0, 0, 0])), i = n.box ? [0, 1, 2].map((u) => n.box[1][u] - n.box[0][u]) : null;
  return z(kn, { children: [
    C("header", { class: "panel-head", children: C("h2", { children: a }) }),
    i && z("p", { class: "crumbs", children: [
      i.map((u) => fn(u, 2)).join(" × "),
      " m"
    ] }),
    z("div", { class: "scroll", children: [
      z("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        z("button", { "aria-pressed": t.every((u) => u.hidden), onClick: () => r(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          C(to, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        z("button", { "aria-pressed": o, onClick: () => r(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          C(to, { name: o ? "lock" : "unlock" }),
          o ? "Locked" : "Lock"
        ] })
      ] }),
      z(R, { title: "Place", note: "re-trace", children: [
        o && C("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        C(
          J,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: o,
            value: [0, 1, 2].map((u) => W(l.map((s) => Math.round(s[u] * 1e4) / 1e4))),
            set: (u, s) => r("move", (p) => ({ place: { position: oe(p.place?.position ?? no(p.box), u, s) } }))
          }
        ),
        [0, 1, 2].map((u) => C(
          q,
          {
            label: `Turn ${"XYZ"[u]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: W(t.map((s) => Math.round(ao(s.place?.rotation, u) * 10) / 10)),
            set: (s) => r("turn", (p) => ({ place: { rotation: $i(u, s(ao(p.place?.rotation, u))) } }))
          },
          u
        )),
        C(
          q,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: o,
            value: W(t.map((u) => u.place?.scale ?? 1)),
            set: (u) => r("scale", (s) => ({ place: { scale: Math.max(1e-3, u(s.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      C(R, { title: "Materials", children: C("ul", { class: "buttons", children: n.materials.map((u) => C("li", { children: C("button", { onClick: () => ro("material", u), children: lo.get(u)?.name ?? `material ${u}` }) }, u)) }) })
    ] })
  ] });
}
function uo() {
  let e = io.value?.ids[0], t = lo.get(e);
  if (!t) return C("p", { class: "quiet empty", children: "This material is gone." });
  let n = (s, p) => oo(`${t.name}: ${s}`, { materials: { [e]: p } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], l = ((s) => 0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2])(o), i = (s) => o.map((p) => Math.max(0, Math.min(1, l > 1e-4 ? p / l * s : s))), u = (s, p) => t[p] != null && z(kn, { children: [
    z("div", { class: "line slide", children: [
      C("span", { children: s }),
      C($e, { label: s, name: `${t.name}: ${s.toLowerCase()}`, value: t[p], text: fn(t[p], 2), patch: (c) => ({ materials: { [e]: { [p]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    C(q, { label: "", name: `${s}, typed`, quantity: "share", step: 0.01, value: t[p], set: (c) => n(s.toLowerCase(), { [p]: Math.max(0, Math.min(1, c(t[p]))) }) })
  ] });
  return z(kn, { children: [
    C("header", { class: "panel-head", children: C("h2", { children: t.name }) }),
    C("p", { class: "crumbs", children: t.kind }),
    z("div", { class: "scroll", children: [
      z(R, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        z("div", { class: "line slide", children: [
          C("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          C($e, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: l, text: fn(l, 2), patch: (s) => ({ materials: { [e]: { [a]: i(Math.min(0.95, s)) } } }) })
        ] }),
        C(q, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(l * 1e3) / 1e3, set: (s) => n("reflectance", { [a]: i(Math.min(0.98, s(l))) }) }),
        z("label", { class: "line", children: [
          C("span", { children: "Colour" }),
          C("input", { type: "color", class: "pick", "aria-label": "Colour", value: Ci(o), onChange: (s) => n("colour", { [a]: Si(s.currentTarget.value) }) })
        ] }),
        u("Roughness", "roughness"),
        u("Gloss", "specular")
      ] }),
      C(R, { title: "On", children: C("ul", { class: "buttons", children: vn.all().filter(([, s]) => s.materials.includes(e)).slice(0, 40).map(([s, p]) => C("li", { children: C("button", { onClick: () => ro("thing", s), children: p.name }) }, s)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as po, jsx as D, jsxs as xn } from "./desk.js";
var Qe = ["Scene", "Things", "Materials", "History"], me = Ti("Scene");
function Ei() {
  let e = { Scene: Qa, Things: Za, Materials: Ja, History: eo }[me.value];
  return xn(po, { children: [
    D("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), me.value = Qe[(Qe.indexOf(me.value) + a + Qe.length) % Qe.length], document.getElementById(`tab-${me.value}`)?.focus());
    }, children: Qe.map((n) => D("button", { id: `tab-${n}`, role: "tab", "aria-selected": me.value === n, "aria-controls": "tab-panel", tabIndex: me.value === n ? 0 : -1, onClick: () => me.value = n, children: n }, n)) }),
    D("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${me.value}`, tabIndex: 0, children: D(e, {}) })
  ] });
}
function Vi() {
  let e = Pi.value;
  return e ? xn(po, { children: [
    xn("nav", { class: "chooser", "aria-label": "Selection", children: [
      D("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => co("previous"), children: D(wn, { name: "back" }) }),
      D("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => co("next"), children: D(wn, { name: "forth" }) }),
      D("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      D("span", { class: "gap" }),
      D("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: Li, children: D(wn, { name: "close" }) })
    ] }),
    (e.kind === "lamp" || e.kind === "group") && D(Ga, {}),
    e.kind === "thing" && D(so, {}),
    e.kind === "material" && D(uo, {}),
    e.kind === "meter" && D(Ca, {}),
    e.kind === "grid" && D($a, {})
  ] }) : D(Ei, {});
}

// src/later/legend.tsx
import { candles as Ai, display as Ii, Field as Ri, show as qi, three as Fi, useRef as Hi } from "./desk.js";
import { jsx as X, jsxs as Lt } from "./desk.js";
var Mn = [1, 2, 5];
function Ni(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, r = 10 ** Math.floor(Math.log10(o)), l = r * (Mn.find((i) => i * r >= o) ?? 10);
    for (let i = Math.ceil(e / l) * l; i <= t * 1.0001; i += l) a.push(i);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let r of Mn) {
      let l = r * 10 ** o;
      l >= e * 0.999 && l <= t * 1.001 && a.push(l);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function Di(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var le = (e, t) => {
  let n = { ...e, ...t };
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && qi({ false_color: n });
};
function mo(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return Mn[a] * 10 ** ((n - a) / 3);
}
function Oi() {
  let e = Ii.value.false_color, t = Hi(null);
  if (!e) return null;
  let n = Ai.value === "fc", a = e.quantity === "illuminance", o = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", r = n ? a ? 1 / 10.7639 : 0.2919 : 1, l = e.colors, i = l?.length ? `linear-gradient(to top, ${l.join(", ")})` : void 0, u = (p) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: p, from: e[p] };
    },
    onPointerMove: (c) => {
      let b = t.current;
      b?.end === p && le(e, { [p]: mo(b.from, Math.round((b.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let b = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      b && (c.preventDefault(), c.stopPropagation(), le(e, { [p]: mo(e[p], b) }));
    }
  }), s = ({ end: p }) => Lt("div", { class: "end", children: [
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
        "aria-valuetext": `${Fi(e[p] * r)} ${o}`,
        ...u(p)
      }
    ),
    X(
      Ri,
      {
        label: p === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[p] * r).toPrecision(3)),
        set: (c) => le(e, { [p]: c(e[p] * r) / r })
      }
    )
  ] });
  return Lt("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    Lt("header", { children: [
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
    X("div", { class: "scale", style: { background: i }, children: Ni(e.low, e.high, e.scale).map((p) => X("span", { style: { bottom: `${100 * Di(p, e)}%` }, children: String(Number((p * r).toPrecision(2))) }, p)) }),
    X(s, { end: "low" }),
    Lt("footer", { children: [
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
  allActions as $n,
  act as xo,
  ask as Qi,
  command as Yi,
  copyText as Zi,
  digits as Ji,
  go as es,
  hear as ts,
  lamps as ns,
  say as Pn,
  select as as,
  send as Tt,
  sheet as Ze,
  shown as os,
  signal as Je,
  useEffect as Ln,
  useLayoutEffect as ls,
  useRef as Vt,
  walkNames as rs,
  whyNotTo as is
} from "./desk.js";

// src/later/csv.ts
import { add as ho, grids as Wi, maintenance as Gi, meters as Ki, scale as bo, scene as go } from "./desk.js";
var Bi = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function Ui() {
  let e = Gi.peek(), t = [["scene", go.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of Ki.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of Wi.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, r] of Object.entries(a)) t.push([o, r == null ? null : r * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, r) => {
      let [l, i] = [r % n.columns, Math.floor(r / n.columns)], u = ho(n.corner, ho(bo(n.u, (l + 0.5) / n.columns), bo(n.v, (i + 0.5) / n.rows)));
      t.push([...u.map((s) => s.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(Bi).join(",")).join(`\r
`) + `\r
`;
}
function Sn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function fo() {
  let e = URL.createObjectURL(new Blob([Ui()], { type: "text/csv" }));
  Sn(`${go.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var ko = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], Pt = new Uint8Array(512), Cn = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  Pt[e] = Pt[e + 255] = t, Cn[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var vo = (e, t) => e && t ? Pt[Cn[e] + Cn[t]] : 0;
function _i(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let r = new Array(n.length + 1).fill(0);
    n.forEach((l, i) => {
      r[i] ^= l, r[i + 1] ^= vo(l, Pt[o]);
    }), n = r;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let r = a[o];
    r && n.forEach((l, i) => a[o + i] ^= vo(l, r));
  }
  return a.slice(e.length);
}
function ji(e, t) {
  let [n, a, o] = ko[t - 1], r = [], l = (b, m) => {
    for (let f = m - 1; f >= 0; f--) r.push(b >> f & 1);
  };
  for (l(4, 4), l(e.length, 8), e.forEach((b) => l(b, 8)), l(0, Math.min(4, n * 8 - r.length)); r.length % 8; ) r.push(0);
  let i = [];
  for (let b = 0; b < r.length; b += 8) i.push(parseInt(r.slice(b, b + 8).join(""), 2));
  for (let b = 236; i.length < n; b ^= 253) i.push(b);
  let u = n / o, s = Array.from({ length: o }, (b, m) => i.slice(m * u, (m + 1) * u)), p = s.map((b) => _i(b, a)), c = (b) => b[0].flatMap((m, f) => b.map((v) => v[f]));
  return [...c(s), ...c(p)];
}
var zi = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function Xi(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function yo(e) {
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
function wo(e) {
  let t = [...new TextEncoder().encode(e)], n = ko.findIndex(([m]) => t.length + 2 <= m) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), r = Array.from({ length: a }, () => new Array(a).fill(!1)), l = (m, f, v) => {
    m < 0 || f < 0 || m >= a || f >= a || (o[f][m] = v, r[f][m] = !0);
  };
  for (let m = 0; m < a; m++)
    l(m, 6, m % 2 === 0), l(6, m, m % 2 === 0);
  for (let [m, f] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let v = -4; v <= 4; v++)
      for (let V = -4; V <= 4; V++) {
        let K = Math.max(Math.abs(V), Math.abs(v));
        l(m + V, f + v, K !== 2 && K !== 4);
      }
  if (n > 1) {
    let m = a - 7;
    for (let f = -2; f <= 2; f++) for (let v = -2; v <= 2; v++) l(m + v, m + f, Math.max(Math.abs(v), Math.abs(f)) !== 1);
  }
  let i = (m) => {
    let f = Xi(m);
    for (let v = 0; v < 15; v++) {
      let V = (f >> v & 1) === 1, K = v < 6 ? v : v < 8 ? v + 1 : a - 15 + v;
      l(8, K, V), l(v < 8 ? a - 1 - v : v < 9 ? 7 : 14 - v, 8, V);
    }
    l(8, a - 8, !0);
  };
  i(0);
  let u = ji(t, n), s = 0;
  for (let m = a - 1; m > 0; m -= 2) {
    m === 6 && (m = 5);
    for (let f = 0; f < a; f++)
      for (let v of [m, m - 1]) {
        let K = (m + 1 & 2) === 0 ? a - 1 - f : f;
        r[K][v] || (o[K][v] = s < u.length * 8 && (u[s >> 3] >> 7 - (s & 7) & 1) === 1, s++);
      }
  }
  let p = (m) => (i(m), o.map((f, v) => f.map((V, K) => V !== (!r[v][K] && zi[m](K, v))))), c = p(0), b = yo(c);
  for (let m = 1; m < 8; m++) {
    let f = p(m), v = yo(f);
    v < b && ([c, b] = [f, v]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as fs, jsx as h, jsxs as $ } from "./desk.js";
function et({ title: e, wide: t, children: n }) {
  let a = Vt(null);
  ls(() => {
    let r = a.current, l = document.activeElement;
    return r.open || r.showModal(), () => l?.focus();
  }, []);
  let o = () => Ze.value = null;
  return h(
    "dialog",
    {
      ref: a,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: o,
      onClick: (r) => r.target === a.current && o(),
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
var ss = [
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
function us() {
  let e = [...new Set($n().map((t) => t.group))];
  return h(et, { title: "All keys", wide: !0, children: $("div", { class: "help", children: [
    $("table", { children: [
      h("caption", { class: "spoken", children: "By hand" }),
      h("thead", { children: $("tr", { children: [
        h("th", { scope: "col", children: "What" }),
        h("th", { scope: "col", children: "Mouse" }),
        h("th", { scope: "col", children: "Keys, in the view" }),
        h("th", { scope: "col", children: "Fingers" })
      ] }) }),
      h("tbody", { children: ss.map(([t, n, a, o]) => $("tr", { children: [
        h("th", { scope: "row", children: t }),
        h("td", { children: n }),
        h("td", { children: a.replace("walking keys", rs.value) }),
        h("td", { children: o })
      ] }, t)) })
    ] }),
    $("div", { class: "columns", children: [
      e.map((t) => $("section", { children: [
        h("h3", { children: t }),
        h("dl", { children: $n().filter((n) => n.group === t && n.keys).map((n) => $(fs, { children: [
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
var Et = Je(""), Ye = Je(0);
function cs() {
  let e = Et.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = $n().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: is(a.id), run: () => xo(a.id) }));
  for (let { name: a, camera: o } of ct())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => es(o, a) });
  if (e.length)
    for (let [a, o] of ns.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => as("lamp", a) });
    }
  return n.slice(0, 60);
}
function ps() {
  let e = cs(), t = Math.min(Ye.value, e.length - 1);
  Ln(() => {
    Et.value = "", Ye.value = 0;
  }, []), Ln(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (Ze.value = null, a.why ? Pn(a.why, "warn") : setTimeout(a.run, 0));
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
        value: Et.value,
        onInput: (a) => {
          Et.value = a.currentTarget.value, Ye.value = 0;
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
var Mo = Je([]);
ts("links", (e) => Mo.value = e.links);
function ms({ text: e }) {
  let t = wo(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, r) => o.map((l, i) => l ? `M${i + 4} ${r + 4}h1v1h-1z` : "").join("")).join("");
  return $("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    h("rect", { width: n, height: n, fill: "#fff" }),
    h("path", { d: a, fill: "#000" })
  ] });
}
function ds() {
  let e = Je(null), t = Vt(e).current;
  return Ln(() => {
    Tt({ do: "links", what: "list" });
  }, []), $(et, { title: "Share by link", children: [
    h("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    h("ul", { class: "links", children: Mo.value.map((n) => $("li", { children: [
      h("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      h("code", { children: n.address }),
      $("span", { class: "buttons", children: [
        h("button", { onClick: () => {
          Zi(n.address);
        }, children: "Copy" }),
        h("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        h("button", { onClick: () => Tt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && h(ms, { text: n.address })
    ] }, n.id)) }),
    $("footer", { children: [
      h("button", { onClick: () => Tt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      h("button", { onClick: () => Tt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function hs() {
  let e = Vt(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    Yi({ do: "save", name: n }), Ze.value = null, Pn(`Saving the version “${n}”.`);
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
function bs() {
  let e = os.value?.head, t = Vt(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    re.value = 0;
    let [o, r] = [Number(n("width")), Number(n("height"))];
    Qi("picture", { format: n("format"), width: o, height: r, batches: Number(n("batches")) }, (l) => {
      l.url ? (re.value = null, Sn(l.name, l.url), Ze.value = null) : re.value = l.progress ?? 0;
    }, (l) => {
      re.value = null, Pn(l, "warn");
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
      h("button", { onClick: () => xo("command"), children: "Copy the command" }),
      h("button", { disabled: re.value !== null, onClick: a, children: re.value === null ? "Render and save" : `${Ji(re.value * 100)} %` })
    ] })
  ] });
}
function gs() {
  switch (Ze.value) {
    case "help":
      return h(us, {});
    case "palette":
      return h(ps, {});
    case "share":
      return h(ds, {});
    case "save":
      return h(hs, {});
    case "picture":
      return h(bs, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import {
  act as vs,
  colorText as So,
  cost as ys,
  css as ks,
  Field as ws,
  groups as xs,
  hovered as At,
  Icon as Ms,
  lamps as Co,
  output as $o,
  pickRow as Ss,
  select as Cs,
  selection as Lo,
  switchOn as $s,
  three as Ls,
  typeGroupLevel as Ps,
  typeLevel as Ts
} from "./desk.js";
import { jsx as Q, jsxs as Tn } from "./desk.js";
function Es() {
  return Tn("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    Q("span", {}),
    Q("span", { children: "Name" }),
    Q("span", { children: "Level" }),
    Q("span", { children: "lm" }),
    Q("span", { children: "White" })
  ] });
}
function Vs({ row: e, index: t, count: n }) {
  let a = e.kind === "lamp" ? Co.get(e.id) : void 0, o = e.kind === "group" ? xs.get(e.id) : void 0, r = a ?? o;
  if (!r) return null;
  let l = Lo.value?.kind === e.kind && Lo.value.ids.includes(e.id), i = a ? a.flux * $o(a) : (o?.lamps ?? []).reduce((s, p) => {
    let c = Co.get(p);
    return s + (c ? c.flux * $o(c) : 0);
  }, 0), u = At.value?.kind === e.kind && At.value.id === e.id;
  return Tn(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${l ? "selected" : ""} ${r.on ? "" : "off"} ${u ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => At.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => At.value = null,
      children: [
        Q("button", { class: "icon power", "aria-pressed": r.on, "aria-label": `${r.name} on`, onClick: () => $s(e, !r.on), children: Q(Ms, { name: "power" }) }),
        Q("button", { class: "row-name", "aria-pressed": l, title: a ? ys(a) : void 0, onClick: (s) => Ss(s, e.kind, e.id), onDblClick: () => vs("frame"), children: Q("span", { children: r.name }) }),
        Q(
          ws,
          {
            label: `${r.name} level`,
            quantity: "level",
            value: r.level,
            flux: a?.flux,
            step: 0.01,
            set: (s) => a ? Ts([e.id], s) : Ps(e.id, s)
          }
        ),
        Q("span", { class: "lumens", children: Ls(i) }),
        a ? Tn("button", { class: "tint", "aria-label": `${r.name} colour: ${So(a)}`, onClick: () => Cs("lamp", e.id), children: [
          Q("i", { class: "swatch", style: { background: ks(a.swatch) } }),
          So(a)
        ] }) : Q("span", {})
      ]
    }
  );
}

// src/later/strip.tsx
import {
  act as Po,
  command as Ro,
  digits as En,
  fade as It,
  Field as As,
  grids as To,
  Icon as qe,
  looks as Eo,
  luxText as ke,
  maintenance as Is,
  meters as Vo,
  select as Ao,
  selection as Rt,
  signal as Rs,
  status as Vn,
  storeLook as qs
} from "./desk.js";
import { Fragment as Os, jsx as M, jsxs as F } from "./desk.js";
var An = Rs("looks");
function Fs() {
  return F("section", { class: "looks", "aria-label": "Looks", children: [
    F("header", { children: [
      M("h2", { children: "Looks" }),
      M("button", { class: "tab", onClick: () => An.value = "meters", children: "Meters" }),
      M("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: qs, children: M(qe, { name: "plus" }) }),
      M("span", { class: "gap" }),
      F("label", { class: "tint", children: [
        "Fade",
        M(As, { label: "Cross-fade", quantity: "seconds", value: It.value, step: 0.5, set: (e) => It.value = Math.max(0, e(It.value)) })
      ] })
    ] }),
    F("ul", { children: [
      Eo.all().map(([e, t], n) => F("li", { class: "look", children: [
        F("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Ro({ do: "look", id: e, what: "recall", seconds: It.peek() }), children: [
          t.picture && M("img", { src: t.picture, alt: "" }),
          M("span", { children: t.name })
        ] }),
        M(Hs, { id: e, name: t.name })
      ] }, e)),
      !Eo.ids.value.length && M("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function Hs({ id: e, name: t }) {
  let n = `look-${e}`, a = (i) => {
    let u = i.getBoundingClientRect(), s = document.getElementById(n);
    s?.style.setProperty("left", `${Math.min(u.left, innerWidth - 296)}px`), s?.style.setProperty("bottom", `${innerHeight - u.top + 4}px`), s?.style.setProperty("top", "auto");
  }, o = { popovertarget: n }, r = () => document.getElementById(n)?.hidePopover(), l = (i, u = {}) => {
    r(), Ro({ do: "look", id: e, what: i, ...u });
  };
  return F(Os, { children: [
    M("button", { class: "icon more", ...o, "aria-label": `More of ${t}`, onPointerDown: (i) => a(i.currentTarget), onFocus: (i) => a(i.currentTarget), children: M(qe, { name: "more" }) }),
    F("div", { id: n, popover: "auto", class: "menu", children: [
      F("label", { class: "line", children: [
        M("span", { children: "Name" }),
        M("span", { class: "field", children: M("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (i) => l("rename", { name: i.currentTarget.value }) }) })
      ] }),
      M("button", { class: "item", onClick: () => l("update"), children: M("span", { children: "Update to what is set now" }) }),
      M("button", { class: "item", onClick: () => l("recall", { seconds: 0 }), children: M("span", { children: "Recall at once" }) }),
      M("button", { class: "item", onClick: () => l("remove"), children: M("span", { children: "Remove" }) })
    ] })
  ] });
}
var Io = () => Vn.value?.stage === "moving" || Vn.value?.stage === "refining" || Vn.value?.stage === "loading";
function Ns() {
  let e = Is.value;
  return F("section", { class: "readings", "aria-label": "Meters and grids", children: [
    F("header", { children: [
      M("h2", { children: "Meters" }),
      M("button", { class: "tab", onClick: () => An.value = "looks", children: "Looks" }),
      M("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => Po("meter-tool"), children: M(qe, { name: "meter" }) }),
      M("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => Po("grid"), children: M(qe, { name: "grid" }) }),
      M("button", { onClick: fo, title: "Save all figures as CSV", children: "CSV" }),
      M("span", { class: "gap" }),
      M("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${En(e, 2)} maintained` })
    ] }),
    F("ul", { children: [
      Vo.all().map(([t, n]) => {
        let a = n.lux, o = !a || a[1] > 0.02 * a[0] || Io();
        return M("li", { children: F("button", { class: "reading", "aria-pressed": Rt.value?.kind === "meter" && Rt.value.ids.includes(t), onClick: () => Ao("meter", t), children: [
          F("span", { class: "tint", children: [
            M(qe, { name: "meter" }),
            n.name
          ] }),
          M("strong", { class: o ? "unsettled" : "", children: a ? ke(a[0] * e) : "…" }),
          F("small", { children: [
            a ? `±${ke(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind
          ] })
        ] }) }, `m${t}`);
      }),
      To.all().map(([t, n]) => {
        let a = n.target, o = a && n.mean != null && n.uniformity != null && n.mean * e >= a.lux && n.uniformity >= a.uniformity;
        return M("li", { children: F("button", { class: "reading", "aria-pressed": Rt.value?.kind === "grid" && Rt.value.ids.includes(t), onClick: () => Ao("grid", t), children: [
          F("span", { class: "tint", children: [
            M(qe, { name: "grid" }),
            n.name,
            " ",
            a && n.mean != null && M("b", { class: o ? "met" : "missed", children: o ? "✓" : "✗" })
          ] }),
          M("strong", { class: Io() ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${ke(n.mean * e)}${n.error == null ? "" : ` ±${ke(n.error * e, !1)}`}` }),
          F("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : En(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : ke(n.min * e, !1),
            " to",
            " ",
            n.max == null ? "…" : ke(n.max * e, !1),
            a ? ` · wants ${ke(a.lux)}, U₀ ${En(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !Vo.ids.value.length && !To.ids.value.length && M("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Ds() {
  return F("div", { class: "strip-parts", "data-tab": An.value, children: [
    M(Fs, {}),
    M(Ns, {})
  ] });
}

// src/later/menus.tsx
import {
  digits as Ws,
  display as Gs,
  Field as qo,
  go as Ks,
  houseLights as In,
  Item as we,
  Range as Bs,
  show as Rn,
  theme as Fo,
  walking as Us
} from "./desk.js";
import { Fragment as qn, jsx as P, jsxs as de } from "./desk.js";
function _s() {
  let e = ct();
  return de(qn, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((t) => P(we, { id: t }, t)),
    P("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((t) => P(we, { id: `preset-${t}` }, t)),
    P("hr", {}),
    e.length > 0 && P("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    e.map(({ name: t, camera: n }, a) => P("button", { class: "item", onClick: () => Ks(n, t), children: P("span", { children: t }) }, a)),
    e.length > 0 && P("hr", {}),
    P(we, { id: "walking", label: Us.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    P(we, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((t) => P(we, { id: `hands-${t}` }, t))
  ] });
}
var js = ["linear", "reinhard", "filmic"];
function zs() {
  let e = Gs.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return de(qn, { children: [
    de("fieldset", { children: [
      P("legend", { children: "Tone curve" }),
      P("div", { class: "segments", children: js.map((n) => P("button", { "aria-pressed": e.tone === n, onClick: () => Rn({ tone: n }), children: n }, n)) })
    ] }),
    de("fieldset", { children: [
      P("legend", { children: "White balance" }),
      de("label", { class: "line", children: [
        P("span", { children: "White" }),
        P(qo, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => Rn({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      de("label", { class: "line", children: [
        P("span", { children: "Tint" }),
        P(qo, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => Rn({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    P("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => P(we, { id: n }, n))
  ] });
}
function Xs() {
  return de(qn, { children: [
    de("label", { class: "line", children: [
      P("span", { children: "House lights" }),
      P(Bs, { label: "House lights", value: In.value, text: `${Ws(In.value * 100)} %`, on: (e) => In.value = Math.max(0.3, e) })
    ] }),
    P("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => P("button", { "aria-pressed": Fo.value === e, onClick: () => Fo.value = e, children: e }, e)) }),
    P("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => P(we, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as qt, cut as Qs, digits as Ho, edit as No, go as Ys, Icon as tt, Range as Zs, setCut as Js, storeView as eu, viewName as tu, views as nu } from "./desk.js";
import { jsx as _, jsxs as Fn } from "./desk.js";
function au() {
  let e = nu.all();
  return Fn("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    _("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => qt("home"), children: _(tt, { name: "home" }) }),
    _("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => qt("frame"), children: _(tt, { name: "frame" }) }),
    _("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => qt("back"), children: _(tt, { name: "back" }) }),
    _("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => qt("forth"), children: _(tt, { name: "forth" }) }),
    _("span", { class: "divide" }),
    e.map(([t, n], a) => Fn(
      "button",
      {
        class: "saved-view",
        "aria-pressed": tu.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click to rename, Delete to remove`,
        onClick: () => Ys(n, n.name ?? "view"),
        onDblClick: () => {
          let o = prompt("Name of the view", n.name ?? "");
          o && No(`Rename the view ${o}`, { views: { [t]: { ...n, name: o } } });
        },
        onKeyDown: (o) => {
          o.key === "Delete" && (o.stopPropagation(), No(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          _("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    _("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: eu, children: _(tt, { name: "plus" }) })
  ] });
}
function ou() {
  let e = Qs.value;
  if (!e) return null;
  let t = e.height === null ? `${Ho(e.value, 2)} m` : `at ${Ho(e.height, 2)} m`;
  return Fn("label", { class: "cut", "data-scroll": !0, children: [
    _("span", { children: "Cut" }),
    _(
      Zs,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => Js(n * e.most)
      }
    ),
    _("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as lu, useRef as ru } from "./desk.js";
import { jsx as Do } from "./desk.js";
function iu() {
  let e = ru(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let r = a.getBoundingClientRect(), l = (s) => Math.max(-1, Math.min(1, s)), i = o ? 0 : l((n.clientX - r.left) / (r.width / 2) - 1), u = o ? 0 : l(1 - (n.clientY - r.top) / (r.height / 2));
    e.current?.style.setProperty("transform", `translate(${i * 28}px, ${-u * 28}px)`), lu(u, i);
  };
  return Do("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: Do("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as Oo,
  closeWhat as Wo,
  digits as su,
  hovered as Go,
  Icon as uu,
  luxText as he,
  nameOf as cu,
  select as pu,
  useEffect as mu,
  useRef as du,
  viewSize as hu,
  what as bu
} from "./desk.js";
import { jsx as G, jsxs as ee } from "./desk.js";
var xe = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], gu = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function fu() {
  let e = bu.value, t = du(null);
  if (mu(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = hu.value, o = [...e.lamps].sort((c, b) => xe(b) - xe(c)), r = o.reduce((c, b) => c + xe(b), 0) || 1, l = o.slice(0, 9), i = r - l.reduce((c, b) => c + xe(b), 0), u = Math.max(8, Math.min(e.x + 12, n - 332)), s = Math.max(8, Math.min(e.y + 12, a - 120 - 28 * Math.min(o.length, 10))), p = e.lux ? `${he(e.lux[0])} ±${he(e.lux[1], !1)}` : "Measuring…";
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
        c.key === "Escape" && (c.stopPropagation(), Wo(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        ee("header", { children: [
          G("strong", { class: e.done ? "" : "unsettled", children: p }),
          G("span", { class: "quiet", children: "what lights this" }),
          G("button", { class: "icon", "aria-label": "Close", onClick: Wo, children: G(uu, { name: "close" }) })
        ] }),
        ee("ol", { children: [
          l.map((c) => G(
            "li",
            {
              onPointerEnter: () => Go.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => Go.value = null,
              children: ee("button", { class: "row", onClick: () => pu("lamp", c.id), children: [
                G("span", { class: "name", children: cu("lamp", c.id) }),
                ee("span", { class: "figure", children: [
                  su(100 * xe(c) / r, xe(c) / r < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                ee("span", { class: "figure lux", children: [
                  he(xe(c)),
                  " ±",
                  he(gu(c), !1)
                ] }),
                ee("span", { class: "bar", "aria-hidden": "true", children: [
                  G("i", { class: "direct", style: { width: `${100 * c.direct[0] / r}%` } }),
                  G("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / r}%` } }),
                  G("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / r}%` } })
                ] }),
                ee("span", { class: "spoken", children: [
                  "direct ",
                  he(c.direct[0]),
                  ", indirect ",
                  he(c.indirect[0]),
                  ", caustic",
                  " ",
                  he(c.caustic[0])
                ] })
              ] })
            },
            c.id
          )),
          o.length > l.length && ee("li", { class: "quiet", children: [
            "and ",
            o.length - l.length,
            " others, ",
            he(i),
            " together"
          ] }),
          !o.length && G("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        ee("footer", { children: [
          G("span", { class: "key direct", children: "direct" }),
          G("span", { class: "key indirect", children: "indirect" }),
          G("span", { class: "key caustic", children: "caustic" }),
          G("span", { class: "gap" }),
          Oo.value.length > 0 && G("button", { onClick: () => Be(Oo.peek(), e.hit.point), children: "Aim here" }),
          G("button", { onClick: () => Ue(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Gl as Compare,
  ou as CutBar,
  Sr as Gizmo,
  Vi as Inspector,
  Oi as Legend,
  Xs as PageItems,
  zs as SeeingItems,
  Es as SheetHead,
  Vs as SheetRow,
  gs as Sheets,
  Ds as Strip,
  _s as ViewItems,
  au as ViewStrip,
  iu as WalkPad,
  fu as What
};
