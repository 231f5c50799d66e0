// src/later/actions.ts
import {
  adding as er,
  asked as tr,
  ask as nr,
  back as ar,
  candles as Ca,
  chosenLamps as de,
  clearSolo as or,
  command as gn,
  compareHeld as lr,
  copyText as rr,
  deselect as ir,
  each as fn,
  edit as vn,
  exposeBy as $a,
  falseColor as sr,
  fine as La,
  forth as ur,
  frameSelection as cr,
  go as pr,
  goHome as dr,
  goInside as mr,
  goPreset as hr,
  handles as Pa,
  hands as gr,
  here as br,
  highlight as fr,
  history as Va,
  lampMarks as Ta,
  lamps as xt,
  listing as Ea,
  lookOnly as Ia,
  panels as Aa,
  PRESETS as vr,
  register as yr,
  say as wt,
  scene as kr,
  selection as Ga,
  send as wr,
  sheet as Qe,
  show as xr,
  soloSelection as Mr,
  spot as Ye,
  startTool as xe,
  stepSelection as Ra,
  storeLook as Sr,
  storeView as Cr,
  theme as qa,
  things as Fa,
  titleOf as Da,
  toggleFalse as $r,
  toggleWipe as Lr,
  travel as Na,
  views as Pr,
  walking as bn,
  whyNot as _
} from "./desk.js";

// src/later/grouping.ts
import { chosenLamps as Xe, groups as ft, lamps as Jl, selection as vt, step as ka, titleOf as wa } from "./desk.js";

// src/later/tools.ts
import {
  add as dt,
  adding as Gl,
  chosenLamps as da,
  distance as Dl,
  dot as Ol,
  edit as mt,
  effect as Wl,
  free as ba,
  grids as ma,
  lamps as Ve,
  meters as ha,
  normal as fa,
  onTool as Kl,
  positionOf as Bl,
  say as ht,
  scale as pt,
  select as Ul,
  step as mn,
  sub as hn,
  titleOf as gt,
  tool as we,
  untracked as _l,
  up as va,
  workPlane as jl
} from "./desk.js";

// src/later/area.ts
import { ask as Pl, camera as Vl, cross as Tl, dot as ke, effect as sa, add as cn, normal as El, scale as Pe, scene as ua, selection as Il, signal as Al, sub as Rl, tool as ql } from "./desk.js";
var Fl = 0.5, Nl = 0.3;
function Hl(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
var ut = (e, t = 0) => e > 2 * t ? e - 2 * t : e;
function dn(e) {
  let [t, n] = [Math.min(...e), Math.max(...e)], a = n >= 2 * t ? t : n, o = a / Math.max(1, Math.round(a / Hl(a)));
  return e.map((l) => Math.max(1, Math.round(l / o)));
}
function ca(e, t, n, a, o) {
  let l = Math.abs(n[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], r = El(Tl(n, l)), s = Rl(t.point, e.point), [p, i] = [ke(s, l), ke(s, r)];
  if (Math.abs(p) < 0.05 || Math.abs(i) < 0.05) return null;
  let u = (ee) => ke(ee, n) - a, c = [e, t].every((ee) => ke(ee.normal, n) > 0.7 && u(ee.point) > Nl), h = c ? 0 : Fl, d = c ? 0 : o - u(e.point), y = cn(cn(e.point, Pe(n, d)), cn(Pe(l, Math.min(p, 0)), Pe(r, Math.min(i, 0)))), v = [Math.abs(p), Math.abs(i)], [E, F] = dn(v.map((ee) => ut(ee, h)));
  return { corner: y, u: Pe(l, v[0]), v: Pe(r, v[1]), normal: n, columns: E, rows: F, border: h };
}
var pa = Al(null);
function ct() {
  let e = ua.value;
  return pa.value ?? (e ? Math.min(ke(e.bounds[0], e.up), ke(e.bounds[1], e.up)) : 0);
}
var pn = null;
sa(() => {
  let e = Vl.value;
  e && !e.height && (pn = e.eye);
});
sa(() => {
  let e = ua.value?.up;
  !e || !pn || ql.value !== "grid" && Il.value?.kind !== "grid" || Pl("ray", { origin: pn, direction: Pe(e, -1) }, (t) => {
    t.hit && (pa.value = ke(t.point, e));
  });
});

// src/later/tools.ts
var Ke = null, zl = { lux: 500, uniformity: 0.6 };
Wl(() => {
  we.value !== "grid" && (Ke = null);
});
function Xl(e) {
  if (!e) return ht("There is nothing at that point.", "warn");
  switch (we.peek()) {
    case "aim":
      Be(da.peek(), e.point), we.value = null;
      break;
    case "place":
      Ql(da.peek(), e), we.value = null;
      break;
    case "meter":
      _e(e.point, e.normal), we.value = null;
      break;
    case "grid":
      if (!Ke) {
        Ke = e;
        return;
      }
      Yl(Ke, e), Ke = null, we.value = null;
      break;
    case "add":
      Zl(Gl.peek(), e), we.value = null;
      break;
  }
}
Kl(Xl);
function Be(e, t) {
  let n = {};
  for (let a of e) {
    let o = Ve.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: fa(hn(t, o.position)) } });
  }
  if (!Object.keys(n).length) return ht("What is selected shines into all directions: it cannot be aimed.", "warn");
  mt(`Aim ${gt(e)}`, { lamps: n });
}
function Ue(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let l = o.filter((r) => !n.has(r));
    l.length && (Ul(t, l[l.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), 3e3);
}
function Ql(e, t) {
  let n = ze(e), a = n.get(e[e.length - 1]);
  if (!a) return ht("What is selected has no place.", "warn");
  let o = (Ve.get(e[e.length - 1])?.place?.radius ?? 0) + 0.02;
  mt(`Put ${gt(e)} on a surface`, je(e, hn(dt(t.point, pt(t.normal, o)), a), n));
}
function _e(e, t) {
  let n = ba(ha);
  Ue(ha, "meter"), mt("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function Yl(e, t) {
  let n = ca(e, t, va.peek(), _l(ct), jl.peek());
  if (!n) return ht("An area needs two corners that lie apart.", "warn");
  let a = ba(ma);
  Ue(ma, "grid"), mt("Lay a grid", { grids: { [a]: { name: `Area ${a + 1}`, ...n, target: zl } } });
}
var ga = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function Zl(e, t) {
  let n = va.peek(), a = Ol(t.normal, n), o = a > 0.7 ? dt(t.point, pt(n, 1.2)) : dt(t.point, pt(t.normal, 0.15)), l = a > 0.7 || a < -0.7 ? pt(n, -1) : t.normal, r = { position: o };
  e !== "point" && e !== "sphere" && (r.direction = l), e === "spot" && Object.assign(r, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (r.radius = 0.15), e === "sphere" && (r.radius = 0.08);
  let s = Ve.all().filter(([, p]) => p.own).length;
  Ue(Ve, "lamp"), mn(`Add ${ga[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${ga[e] ?? e} ${s + 1}`, kind: e, flux: 800, place: r }
  });
}
function bt(e, t, n) {
  !e.length || t < 1 || mn(`Copy ${gt(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function ya(e) {
  e.length && mn(`Remove ${gt(e)}`, { do: "remove", lamps: e });
}
function je(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = Ve.get(o)?.place, r = n.get(o);
    if (!r) continue;
    let s = dt(r, t), p = l?.aim && Dl(l.aim, s) > 1e-6 ? { direction: fa(hn(l.aim, s)) } : {};
    a[o] = { place: { position: s, ...p } };
  }
  return { lamps: a };
}
function ze(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = Ve.get(n), o = a && Bl(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/grouping.ts
var xa = (e) => {
  let t = Jl.get(e)?.group ?? null;
  return t !== null && (ft.get(t)?.lamps.length ?? 0) > 1 ? t : null;
};
function yt() {
  return Xe.value.length < 2 ? "Select two lamps or more first." : vt.value?.kind === "group" && vt.value.ids.length === 1 ? "This is a group already." : null;
}
function Ma() {
  let e = new Set(ft.all().map(([, n]) => n.name)), t = 1;
  for (; e.has(`Group ${t}`); ) t++;
  Ue(ft, "group"), ka(`Group ${wa(Xe.peek())}`, { do: "group", lamps: Xe.peek(), name: `Group ${t}` });
}
function kt() {
  return Xe.value.some((e) => xa(e) !== null) ? null : "What is selected is in no group.";
}
function Sa() {
  let e = vt.peek(), t = Xe.peek().filter((a) => xa(a) !== null), n = e?.kind === "group" && e.ids.length === 1 ? ft.get(e.ids[0]) : void 0;
  ka(n ? `Dissolve ${n.name}` : `Take ${wa(t)} out`, { do: "group", lamps: t }), vt.value = { kind: "lamp", ids: t };
}

// src/later/actions.ts
var le = () => _() ?? (de.value.length ? null : "Select a lamp first.");
function Vr() {
  let e = de.peek(), t = !e.some((n) => xt.get(n)?.on);
  vn(`${Da(e)} ${t ? "on" : "off"}`, { lamps: fn(e, { on: t }) });
}
function Tr() {
  let e = de.peek(), t = !e.every((n) => xt.get(n)?.parked);
  vn(`${t ? "Park" : "Unpark"} ${Da(e)}`, { lamps: fn(e, { parked: t }) });
}
function Ha(e) {
  let t = Ga.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : Fa.ids.peek().filter((a) => Fa.get(a)?.hidden);
  if (!n.length) return wt(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  vn(e ? "Hide things" : "Show hidden things", { things: fn(n, { hidden: e }) });
}
function Er() {
  let e = de.peek()[0], t = xt.get(e)?.place, n = br();
  if (!t?.position || !t.direction || !n) return wt("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  pr({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function Ir() {
  nr("command", {}, (e) => {
    rr(e.text);
  });
}
var Ar = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Rr = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, qr = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: cr },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: dr },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: mr },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: ar },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: ur },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Cr, why: _ },
  ...vr.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Rr[e],
    keys: `Shift+${t + 1}`,
    run: () => hr(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      bn.value = bn.peek() === "walk" ? "fly" : "walk", wt(bn.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: Er, why: le },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => Ra(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => Ra(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => xe("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => Ga.value = { kind: "lamp", ids: xt.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: ir },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: Vr, why: le },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Mr, why: () => de.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: or },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => fr(!0), why: le },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Tr, why: le },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => xe("aim"), why: le },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => Ye.peek() && Be(de.peek(), Ye.peek().point), why: le },
  { id: "place", group: "Lamps", label: "Put on a surface by pointing", keys: "Shift+N", run: () => xe("place"), why: le },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => Pa.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => Pa.value = "turn" },
  ...Ar.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: _,
    run: () => {
      er.value = e, xe("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => bt(de.peek(), 1, [0.5, 0, 0]), why: le },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => ya(de.peek()), why: le },
  { id: "group", group: "Lamps", label: "Group: one master for those selected", keys: "Ctrl+G", run: Ma, why: () => _() ?? yt() },
  { id: "ungroup", group: "Lamps", label: "Dissolve the group, or take lamps out of it", keys: "Ctrl+Shift+G", run: Sa, why: () => _() ?? kt() },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => Ha(!0), why: _ },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => Ha(!1), why: _ },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => gn({ do: "undo" }), why: () => _() ?? (Va.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => gn({ do: "redo" }), why: () => _() ?? (Va.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => Qe.value = "save", why: _ },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => Qe.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Ir },
  { id: "share", group: "Work", label: "Share by link", run: () => Qe.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: $r },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = sr();
      xr({ false_color: { ...tr(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => $a(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => $a(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => wr({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => lr(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: Lr },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: _, run: () => Ye.peek() ? _e(Ye.peek().point, Ye.peek().normal) : xe("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => xe("meter"), why: _ },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => xe("grid"), why: _ },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => gn({ do: "reach" }), why: _ },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => Ca.value = Ca.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Sr, why: _ },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => wt("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => Aa.value = !Aa.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => Ea.value = Ea.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => Na.value = Na.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => Ta.value = !Ta.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => La.value = !La.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => qa.value = qa.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => Ia.value = !Ia.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => gr.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => Qe.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => Qe.value = "palette" }
];
yr(qr);
function Mt() {
  return [...(kr.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...Pr.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as Fr, comparing as Nr, digits as Hr, fitted as Gr, useEffect as Dr, useRef as Or, viewSize as Wr, wipeAt as yn } from "./desk.js";
import { Fragment as Br, jsx as kn, jsxs as Ur } from "./desk.js";
function Kr() {
  let e = Nr.value, t = Fr.value, n = Or(null);
  if (Dr(() => {
    let i = n.current;
    !i || !t || (i.width = t.picture.width, i.height = t.picture.height, i.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = Wr.value, o = yn.value, l = Gr(t.picture.width, t.picture.height), r = Math.max(0, Math.min(1, (o * a - l.x) / (t.picture.width * l.scale))), s = (i) => {
    let u = i.currentTarget;
    if (i.stopPropagation(), i.type === "pointerdown") u.setPointerCapture(i.pointerId);
    else if (u.hasPointerCapture(i.pointerId)) {
      let c = u.parentElement.getBoundingClientRect();
      yn.value = Math.max(0, Math.min(1, (i.clientX - c.left) / c.width));
    }
  }, p = (i) => {
    let u = { ArrowLeft: -0.02, ArrowRight: 0.02 }[i.key];
    u && (i.stopPropagation(), i.preventDefault(), yn.value = Math.max(0, Math.min(1, o + u)));
  };
  return Ur(Br, { children: [
    kn(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * r}% 0 0)` : "none" }
      }
    ),
    kn("span", { class: "tag left", children: "before" }),
    e === "wipe" && kn(
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
        "aria-valuetext": `${Hr(o * 100)} % before`,
        style: { left: `${100 * o}%` },
        onPointerDown: s,
        onPointerMove: s,
        onKeyDown: p
      }
    )
  ] });
}

// src/later/handles.tsx
import {
  add as _a,
  chosenLamps as ei,
  computed as Mn,
  editor as ti,
  effect as ni,
  fitted as ai,
  Gesture as oi,
  handles as li,
  lamps as Ct,
  lookOnly as ri,
  middle as ii,
  nameOf as si,
  normal as ui,
  pinhole as ci,
  positionOf as za,
  role as pi,
  selection as di,
  shown as mi,
  sub as hi,
  things as $t,
  titleOf as gi,
  tool as bi,
  turn as ja,
  useEffect as fi,
  useRef as vi,
  viewSize as yi
} from "./desk.js";

// src/later/gizmo.ts
import { project as Oa, ray as _r } from "./desk.js";
import { across as jr, add as re, cross as zr, distance as Xr, dot as me, length as Qr, normal as wn, scale as ie, sub as Te } from "./desk.js";
var Yr = "http://www.w3.org/2000/svg", xn = 84, Me = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], St = ["x", "y", "z"], Wa = 0.1, Zr = 5 * Math.PI / 180, Ka = 48;
function Ua(e, t) {
  let n = (m, b, k) => {
    let w = document.createElementNS(Yr, m);
    return w.setAttribute("class", k), b.append(w), w;
  }, a = (m, b, k) => {
    let w = n("g", e, `handle ${m} ${St[b] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), l = Me.map((m, b) => a("ring", b, `ring-${St[b]}`)), r = Me.map((m, b) => a("plane", b, `plane-${St[b]}`)), s = Me.map((m, b) => a("arrow", b, `move-${St[b]}`)), p = a("centre", -1, "move-view"), i = a("aim", -1, "aim"), u = n("text", e, "handle-text"), c = (m, b) => {
    let [k, w, I] = Oa(m.hole, b);
    return I < 0.02 && !m.hole.parallel ? null : [m.fit.x + k * m.fit.scale, m.fit.y + w * m.fit.scale];
  }, h = (m, b) => {
    let k = Oa(m.hole, b)[2];
    return xn / m.fit.scale * m.hole.pixel * (m.hole.parallel ? 1 : Math.max(k, 0.02));
  }, d = (m, b, k = !1) => {
    let w = b.filter(($) => $ !== null), I = w.length < b.length || w.length < 2 ? "" : `M${w.map(($) => `${$[0].toFixed(1)} ${$[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    m.setAttribute("d", I);
  }, y = (m, b, k) => {
    m.setAttribute("d", b ? `M${b[0] - k} ${b[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, v = (m, b) => m.forEach((k) => k.group.classList.toggle("gone", !b));
  function E(m, b) {
    let k = m.position, w = c(b, k), I = h(b, k), $ = m.mode === "move";
    v([...s, ...r, p], $ && w !== null), v(l, !$ && w !== null && m.turns);
    let z = m.aim ?? (m.direction ? re(k, ie(m.direction, 3 * I)) : null);
    if (v([i], z !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    Me.forEach((O, U) => {
      let q = c(b, re(k, ie(O, I))), rt = q ? Math.hypot(q[0] - w[0], q[1] - w[1]) < 12 : !0;
      if (s[U].group.classList.toggle("gone", !$ || rt), q && $) {
        let [ye, Oe] = [(q[0] - w[0]) / xn, (q[1] - w[1]) / xn], st = Math.hypot(ye, Oe) || 1, [pe, We] = [ye / st, Oe / st], un = [w[0] + 14 * pe, w[1] + 14 * We];
        d(s[U].hit, [un, q]), s[U].seen.setAttribute("d", `M${un[0].toFixed(1)} ${un[1].toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}M${(q[0] - 9 * pe - 4.5 * We).toFixed(1)} ${(q[1] - 9 * We + 4.5 * pe).toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}L${(q[0] - 9 * pe + 4.5 * We).toFixed(1)} ${(q[1] - 9 * We - 4.5 * pe).toFixed(1)}`);
      }
      let [Ge, De] = [Me[(U + 1) % 3], Me[(U + 2) % 3]], Z = Math.abs(me(O, b.hole.parallel ? b.hole.forward : wn(Te(k, b.hole.eye)))) < 0.15;
      r[U].group.classList.toggle("gone", !$ || Z);
      let it = (ye, Oe) => c(b, re(k, re(ie(Ge, ye * I), ie(De, Oe * I)))), ia = [it(0.3, 0.3), it(0.5, 0.3), it(0.5, 0.5), it(0.3, 0.5)];
      if (d(r[U].hit, ia, !0), d(r[U].seen, ia, !0), !$) {
        let ye = Array.from({ length: Ka + 1 }, (Oe, st) => {
          let pe = 2 * Math.PI * st / Ka;
          return c(b, re(k, re(ie(Ge, Math.cos(pe) * I), ie(De, Math.sin(pe) * I))));
        });
        d(l[U].hit, ye), d(l[U].seen, ye);
      }
    }), y(p.hit, w, 13), y(p.seen, w, 7);
    let R = z && c(b, z);
    d(o, [w, R]), y(i.hit, R, 16), i.seen.setAttribute("d", R ? `M${R[0] - 8} ${R[1]}h16M${R[0]} ${R[1] - 8}v16M${R[0] - 5} ${R[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let F = t.effect(() => {
    let m = t.target.value, b = t.view.value;
    e.classList.toggle("empty", !m || !b), m && b && E(m, b);
  }), ee = (m, b, k) => _r(m.hole, (b.clientX - k.left - m.fit.x) / m.fit.scale, (b.clientY - k.top - m.fit.y) / m.fit.scale);
  function ve(m, b, k) {
    m.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let I = t.view.peek();
      if (!I || !t.target.peek()) return;
      let $ = e.getBoundingClientRect(), z = k(I), R = t.hold(b), O = ee(I, w, $);
      z(O, !1, { ...R, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), m.setPointerCapture(w.pointerId), m.classList.add("held");
      let U = (Z) => {
        u.textContent = z(ee(I, Z, $), Z.ctrlKey || Z.metaKey, R), u.setAttribute("x", String(Z.clientX - $.left + 16)), u.setAttribute("y", String(Z.clientY - $.top - 12));
      }, q = (Z) => {
        m.removeEventListener("pointermove", U), m.removeEventListener("pointerup", rt), m.removeEventListener("pointercancel", Ge), removeEventListener("keydown", De, !0), m.classList.remove("held"), u.textContent = "", Z ? R.end() : R.cancel();
      }, rt = () => q(!0), Ge = () => q(!1), De = (Z) => {
        Z.key === "Escape" && (Z.stopPropagation(), q(!1));
      };
      m.addEventListener("pointermove", U), m.addEventListener("pointerup", rt), m.addEventListener("pointercancel", Ge), addEventListener("keydown", De, !0);
    });
  }
  let rn = (m, b, k) => k ? Math.round(m / b) * b : m, sn = (m) => m.map((b) => b.toFixed(2)).join("  ") + " m";
  Me.forEach((m, b) => {
    ve(s[b].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (I, $, z) => {
        let R = Jr(k, m, I);
        w ??= R;
        let O = ie(m, rn(R - w, Wa, $));
        return z.move(O), sn(O);
      };
    }), ve(r[b].group, "move", () => la(m)), ve(l[b].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (I, $, z) => {
        let R = Ba(k.position, m, I), O = R && wn(Te(R, k.position), jr(m));
        if (!O) return "";
        w.at ??= O;
        let U = Math.atan2(me(m, zr(w.at, O)), me(w.at, O)), q = rn(U, Zr, $);
        return z.rotate(m, q), `${(q * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), ve(p.group, "move", (m) => la(m.hole.forward)), ve(i.group, "aim", (m) => {
    let b = t.target.peek(), k = b.aim ?? re(b.position, ie(b.direction, 3 * h(m, b.position))), w = ra(k, m.hole.forward);
    return (I, $, z) => {
      let R = w(I, $), O = re(k, R);
      return Xr(O, b.position) > 1e-3 && z.turn(wn(Te(O, b.position)), O), sn(O);
    };
  });
  function la(m) {
    let b = ra(t.target.peek().position, m);
    return (k, w, I) => {
      let $ = b(k, w);
      return I.move($), sn($);
    };
  }
  function ra(m, b) {
    let k = null;
    return (w, I) => {
      let $ = Ba(m, b, w);
      return $ ? (k ??= $, Te($, k).map((z) => rn(z, Wa, I))) : [0, 0, 0];
    };
  }
  return { stop: F };
}
function Jr(e, t, n) {
  let a = Te(e, n.origin), o = me(t, n.direction), l = 1 - o * o;
  return l < 1e-6 ? 0 : (o * me(n.direction, a) - me(t, a)) / l;
}
function Ba(e, t, n) {
  let a = me(t, n.direction);
  if (Math.abs(a) < 1e-4 * Qr(t)) return null;
  let o = me(Te(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : re(n.origin, ie(n.direction, o));
}

// src/later/handles.tsx
import { jsx as $i } from "./desk.js";
function ki([e, t, n, a], [o, l, r, s]) {
  return [
    a * o + e * s + t * r - n * l,
    a * l - e * r + t * s + n * o,
    a * r + e * l - t * o + n * s,
    a * s - e * o - t * l - n * r
  ];
}
var wi = () => !ri.value && pi.value !== "watch" && ti.value.you && bi.value !== "aim", Xa = Mn(() => {
  let e = di.value;
  if (!e || !wi()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => $t.get(a) && !$t.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = ei.value.filter((n) => za(Ct.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), Qa = (e) => {
  let t = $t.get(e);
  return t?.place?.position ?? (t?.box ? ii(t.box) : null);
}, xi = Mn(() => {
  let e = Xa.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? za(Ct.get(t)) : Qa(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? Ct.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: li.value
  };
}), Mi = Mn(() => {
  let e = mi.value;
  if (yi.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: ci(e.camera, t, n), fit: ai(t, n) };
}), Si = {
  effect: ni,
  target: xi,
  view: Mi,
  hold(e) {
    let t = Xa.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? gi(n) : n.length === 1 ? si("thing", n[0]) : `${n.length} things`, l = new oi(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), r = a === "lamps" ? ze(n) : new Map(n.map((i) => [i, Qa(i)])), s = new Map(n.map((i) => [i, (a === "lamps" ? Ct : $t).get(i)?.place])), p = (i) => {
      let u = n.map((c) => [c, i(c)]).filter(([, c]) => c);
      l.set({ [a]: Object.fromEntries(u.map(([c, h]) => [c, { place: h }])) });
    };
    return {
      move: (i) => a === "lamps" ? l.set(je(n, i, r)) : p((u) => ({ position: _a(r.get(u), i) })),
      turn: (i, u) => p((c) => s.get(c)?.direction ? { direction: i, ...u ? { aim: u } : {} } : null),
      rotate: (i, u) => p((c) => {
        let h = s.get(c);
        if (h?.direction) {
          let v = ui(ja(h.direction, i, u)), E = h.aim && h.position ? ja(hi(h.aim, h.position), i, u) : null;
          return { direction: v, ...E ? { aim: _a(h.position, E) } : {} };
        }
        let d = Math.sin(u / 2), y = [i[0] * d, i[1] * d, i[2] * d, Math.cos(u / 2)];
        return { rotation: ki(y, h?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => l.end(),
      cancel: () => l.cancel()
    };
  }
};
function Ci() {
  let e = vi(null);
  return fi(() => Ua(e.current, Si).stop, []), $i("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as Jo, deselect as As, Icon as Un, penless as _n, selection as Rs, signal as qs } from "./desk.js";

// src/later/measure.tsx
import {
  add as Ai,
  deselect as so,
  digits as Se,
  dot as Ri,
  edit as At,
  grids as qi,
  Icon as uo,
  length as It,
  luxText as Ae,
  maintenance as Ln,
  meters as Fi,
  scale as Ni,
  selection as co,
  up as ro
} from "./desk.js";

// src/later/figures.tsx
import { maintenance as Za, status as Sn } from "./desk.js";

// src/later/verdict.ts
function Ya(e, t) {
  let n = ({ value: o, error: l, least: r }) => {
    let s = t ? 0 : l ?? 1 / 0;
    return o - s >= r ? "met" : o + s < r ? "missed" : "open";
  }, a = e.map(n);
  return a.includes("missed") ? "missed" : a.includes("open") ? "open" : "met";
}

// src/later/figures.tsx
import { jsx as oo } from "./desk.js";
var Ja = () => Sn.value?.stage === "moving" || Sn.value?.stage === "loading", Li = () => Ja() || Sn.value?.stage === "refining", eo = { meter: 0.02, grid: 0.05 };
function to(e, t, n) {
  return e == null || t == null || t > n * e || Li();
}
var Lt = ({ lux: e }) => to(e?.[0], e?.[1], eo.meter), Pt = ({ mean: e, error: t }) => to(e, t, eo.grid), no = (e, t) => Ja() ? "open" : Ya(e, t === !0);
function Vt({ lux: e, target: t, done: n }) {
  if (!e || !t) return null;
  let a = Za.value;
  return no([{ value: e[0] * a, error: e[1] == null ? null : e[1] * a, least: t }], n);
}
function Tt({ mean: e, error: t, uniformity: n, uniformity_error: a, target: o, done: l }) {
  if (!o || e == null || n == null) return null;
  let r = Za.value;
  return no([
    { value: e * r, error: t == null ? null : t * r, least: o.lux },
    { value: n, error: a ?? null, least: o.uniformity }
  ], l);
}
var ao = {
  met: ["✓", "reaches its target"],
  missed: ["✗", "misses its target"],
  open: ["≈", "within its ± of the target: not decided yet"]
};
function Cn({ of: e }) {
  if (!e) return null;
  let [t, n] = ao[e];
  return oo("b", { class: e, role: "img", "aria-label": n, title: n, children: t });
}
function $n({ of: e }) {
  if (!e) return null;
  let [t, n] = ao[e];
  return oo("p", { class: e, children: `${t} ${n[0].toUpperCase()}${n.slice(1)}` });
}

// src/later/parts.tsx
import { Field as lo, Gesture as Pi, Range as Vi, stroke as Ti, useRef as Ei } from "./desk.js";
import { jsx as se, jsxs as Et } from "./desk.js";
function A({ title: e, note: t, children: n }) {
  return Et("section", { class: "part", "aria-label": e, children: [
    Et("h3", { children: [
      e,
      t && se("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function K(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function V(e) {
  return Et("label", { class: "line", children: [
    se("span", { children: e.label }),
    se(lo, { ...e, label: e.name ?? e.label })
  ] });
}
function Ii(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function J({ label: e, names: t, quantity: n, value: a, set: o, step: l, disabled: r }) {
  let s = t ?? ["X", "Y", "Z"];
  return Et("div", { class: "line", role: "group", "aria-label": e, children: [
    se("span", { children: e }),
    se("span", { class: "triple", children: s.map((p, i) => se(
      lo,
      {
        label: `${e} ${p}`,
        quantity: n,
        value: a[i],
        text: Ii(a[i], n),
        step: l,
        disabled: r,
        set: (u) => o(i, u)
      },
      p
    )) })
  ] });
}
function Ee({ label: e, name: t, value: n, text: a, patch: o, reset: l, notch: r, class: s, style: p, disabled: i }) {
  let u = Ei(null), c = (d) => () => {
    u.current?.[d](), u.current = null;
  }, h = (d) => u.current ? u.current.set(o(d)) : Ti(e + t, t, o(d));
  return se(
    Vi,
    {
      label: e,
      value: n,
      text: a,
      notch: r,
      class: s,
      gradient: p,
      disabled: i,
      begin: () => u.current = new Pi(t),
      on: h,
      end: c("end"),
      cancel: c("cancel"),
      reset: l === void 0 ? void 0 : () => h(l)
    }
  );
}
function Ie({ value: e, label: t, set: n }) {
  return se("span", { class: "field name-field", children: se(
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
var ue = (e, t, n) => e.map((a, o) => o === t ? n(a) : a);

// src/later/measure.tsx
import { Fragment as Pn, jsx as S, jsxs as j } from "./desk.js";
var Hi = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function po() {
  let e = co.value?.ids[0], t = Fi.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: l, done: r, ...s } = { ...t, ...o };
    At(`${t.name}: ${a}`, { meters: { [e]: s } });
  };
  return j(Pn, { children: [
    S("header", { class: "panel-head", children: S(Ie, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    S("p", { class: `crumbs ${Lt(t) ? "unsettled" : "known"}`, children: t.lux?.[1] != null ? `${Ae(t.lux[0] * Ln.value)} ±${Ae(t.lux[1] * Ln.value, !1)}` : "measuring" }),
    S("div", { class: "scroll", children: j(A, { title: "Meter", children: [
      j("label", { class: "line", children: [
        S("span", { children: "Measures" }),
        S("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: Hi.map(([a, o]) => S("option", { value: a, children: o }, a)) })
      ] }),
      S(J, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: ue(t.point, a, o) }) }),
      S(V, { label: "At least", quantity: "lux", step: 50, value: t.target ?? 0, set: (a) => n("target", { target: a(t.target ?? 0) || null }) }),
      S($n, { of: Vt(t) }),
      S(J, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: ue(t.normal, a, o) }) }),
      j("button", { class: "plain full", onClick: () => {
        so(), At(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        S(uo, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var io = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function mo() {
  let e = co.value?.ids[0], t = qi.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This grid is gone." });
  let n = Ln.value, a = (i, u) => {
    let { name: c, corner: h, u: d, v: y, normal: v, columns: E, rows: F, border: ee, target: ve } = { ...t, ...u };
    At(`${t.name}: ${i}`, { grids: { [e]: { name: c, corner: h, u: d, v: y, normal: v, columns: E, rows: F, border: ee, target: ve } } });
  }, o = (i, u = t.border) => {
    let [c, h] = dn([ut(It(t.u), u), ut(It(t.v), u)]);
    a(i, { columns: c, rows: h, border: u });
  }, l = Ri(t.corner, ro.value) - ct(), r = (i, u, c) => j(Pn, { children: [
    S("dt", { children: i }),
    S("dd", { children: u == null ? "…" : c(u) })
  ] }), s = (i, u) => i == null ? "" : ` ±${u(i)}`, p = t.target ?? { lux: 500, uniformity: 0.6 };
  return j(Pn, { children: [
    S("header", { class: "panel-head", children: S(Ie, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    j("p", { class: "crumbs", children: [
      Se(It(t.u), 2),
      " × ",
      Se(It(t.v), 2),
      " m, ",
      Se(t.columns * t.rows),
      " points"
    ] }),
    j("div", { class: "scroll", children: [
      S(A, { title: "Figures", note: n === 1 ? "new" : `× ${Se(n, 2)}`, children: j("dl", { class: `figures ${Pt(t) ? "unsettled" : ""}`, children: [
        r("Ē", t.mean, (i) => Ae(i * n) + s(t.error, (u) => Ae(u * n, !1))),
        r("E min", t.min, (i) => Ae(i * n)),
        r("E max", t.max, (i) => Ae(i * n)),
        r("U₀ = min / mean", t.uniformity, (i) => Se(i, 2) + s(t.uniformity_error, (u) => Se(u, 2))),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => Se(i, 2))
      ] }) }),
      j(A, { title: "Target", children: [
        S($n, { of: Tt(t) }),
        j("label", { class: "line", children: [
          S("span", { children: "Class" }),
          j("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let u = io[Number(i.currentTarget.value)];
            a("target", { target: u ? { lux: u[1], uniformity: u[2] } : null });
          }, children: [
            S("option", { value: "", children: t.target ? "choose…" : "none" }),
            io.map(([i, u, c], h) => j("option", { value: h, children: [
              i,
              ": ",
              u,
              " lx, U₀ ",
              c
            ] }, i)),
            S("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        S(V, { label: "Ē at least", quantity: "lux", step: 50, value: p.lux, set: (i) => a("target", { target: { ...p, lux: i(p.lux) } }) }),
        S(V, { label: "U₀ at least", quantity: "share", step: 0.05, value: p.uniformity, set: (i) => a("target", { target: { ...p, uniformity: i(p.uniformity) } }) })
      ] }),
      j(A, { title: "Area", children: [
        S(J, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, u) => a("move", { corner: ue(t.corner, i, u) }) }),
        S(V, { label: "Height", name: "Height above the floor", quantity: "length", step: 0.01, value: l, set: (i) => a("height", { corner: Ai(t.corner, Ni(ro.value, i(l) - l)) }) }),
        S(V, { label: "Border", quantity: "length", step: 0.05, value: t.border ?? 0, set: (i) => o("border", Math.max(0, i(t.border ?? 0))) }),
        S(V, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        S(V, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        S("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: () => o("standard spacing"), children: "Spacing of the standard" }),
        j("button", { class: "plain full", onClick: () => {
          so(), At(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          S(uo, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as ae,
  chosenLamps as Zi,
  dot as An,
  edit as Ft,
  format as So,
  groups as Nt,
  handles as Rt,
  Icon as qe,
  lamps as Fn,
  layers as Ji,
  lumensOf as es,
  normal as Co,
  output as ts,
  percent as qn,
  positionOf as vo,
  selection as $o,
  signal as Lo,
  spot as ns,
  sub as yo,
  titleOf as Nn,
  tool as Po,
  toLevel as ko,
  toTravel as as,
  typeLevel as Rn,
  up as os,
  Fade as ls,
  Field as rs,
  wantLevel as wo,
  compass as Vo,
  add as Ht,
  scale as Fe,
  length as is,
  Range as ss,
  strokeLevel as xo,
  typeGroupLevel as us,
  useRef as cs
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as Wi,
  digits as go,
  edit as Ki,
  fromHex as Bi,
  hex as Ui,
  lamps as bo,
  mired as Ce,
  titleOf as _i
} from "./desk.js";

// src/later/white.ts
import { css as Gi, mired as Vn } from "./desk.js";
function Di(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((l) => Math.max(0, l));
}
function Oi(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function ho(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, l) => {
    let r = Vn(e) + (Vn(t) - Vn(e)) * l / (n - 1);
    return Gi(Di(...Oi(1e6 / r)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as En, jsx as G, jsxs as he } from "./desk.js";
var Ze = 1800, In = 1e4, ji = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], zi = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], Xi = ho(Ze, In), Tn = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(bo.get(n).color) }]))
}), Qi = (e) => {
  let t = 1e6 / (Ce(Ze) + (Ce(In) - Ce(Ze)) * e);
  return Math.round(t / 10) * 10;
}, Yi = (e) => (Ce(e) - Ce(Ze)) / (Ce(In) - Ce(Ze));
function fo() {
  let e = Wi.value, t = e.map((r) => bo.get(r)?.color).filter((r) => r !== void 0);
  if (!t.length) return null;
  let n = K(t.map((r) => r.mode)), a = t[0], o = _i(e), l = (r, s) => Ki(`${o}: ${r}`, Tn(e, s));
  return he(En, { children: [
    he("div", { class: "line", children: [
      G("span", { children: "Colour" }),
      G("div", { class: "segments", role: "group", "aria-label": "Colour by", children: zi.map(([r, s]) => G("button", { "aria-pressed": n === r, onClick: () => l(`colour by ${s}`, () => ({ mode: r })), children: s }, r)) })
    ] }),
    n === "kelvin" && he(En, { children: [
      he("div", { class: "line slide", children: [
        G("span", { children: "White" }),
        G(
          Ee,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: Xi,
            value: Yi(a.kelvin),
            text: `${go(a.kelvin)} kelvin`,
            patch: (r) => Tn(e, () => ({ mode: "kelvin", kelvin: Qi(r) }))
          }
        )
      ] }),
      G(
        V,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: K(t.map((r) => r.kelvin)),
          step: 50,
          set: (r) => l("white", (s) => ({ mode: "kelvin", kelvin: r(s.kelvin) }))
        }
      ),
      G("div", { class: "whites", role: "group", "aria-label": "Whites", children: ji.map(([r, s]) => G("button", { title: s, "aria-label": `${r} kelvin, ${s}`, onClick: () => l(`${r} K`, () => ({ mode: "kelvin", kelvin: r })), children: r }, r)) }),
      he("div", { class: "line slide", children: [
        G("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        G(
          Ee,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${go(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (r) => Tn(e, () => ({ tint: Math.round((r * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      G(V, { label: "", name: "Tint, typed", quantity: "number", value: K(t.map((r) => r.tint)), step: 1, set: (r) => l("tint", (s) => ({ tint: Math.max(-50, Math.min(50, r(s.tint))) })) })
    ] }),
    n === "rgb" && he(En, { children: [
      he("label", { class: "line", children: [
        G("span", { children: "Colour" }),
        G("input", { type: "color", class: "pick", "aria-label": "Colour", value: Ui(a.rgb), onChange: (r) => l("colour", () => ({ mode: "rgb", rgb: Bi(r.currentTarget.value) })) })
      ] }),
      G(
        J,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (r, s) => l("colour", (p) => ({ rgb: p.rgb.map((i, u) => u === r ? Math.max(0, s(i)) : i) }))
        }
      )
    ] }),
    n === "xy" && he("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      G("span", { children: "x, y" }),
      G("span", { class: "triple", children: [0, 1].map((r) => G(
        V,
        {
          label: "xy"[r],
          quantity: "number",
          step: 1e-3,
          value: K(t.map((s) => s.xy[r])),
          set: (s) => l("chromaticity", (p) => ({ xy: p.xy.map((i, u) => u === r ? Math.max(0.01, Math.min(0.9, s(i))) : i) }))
        },
        r
      )) })
    ] }),
    n === null && G("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as Hn, jsx as f, jsxs as D } from "./desk.js";
var Re = Lo(1), qt = Lo([1, 0, 0]), ps = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], Gt = 180 / Math.PI;
function Mo(e, t) {
  let { right: n, ahead: a } = Vo(t), o = -An(e, t);
  return [Math.atan2(An(e, n), An(e, a)) * Gt, Math.asin(Math.max(-1, Math.min(1, o))) * Gt];
}
function ds(e, t, n) {
  let { right: a, ahead: o } = Vo(n), [l, r] = [e / Gt, t / Gt], s = Ht(Fe(a, Math.sin(l)), Fe(o, Math.cos(l)));
  return Co(Ht(Fe(s, Math.cos(r)), Fe(n, -Math.sin(r))));
}
function ms({ ids: e, all: t }) {
  let n = t.some((o) => o.place?.direction), a = $o.value?.kind === "group";
  return D("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    D("button", { "aria-pressed": Po.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => ae("aim"), children: [
      f(qe, { name: "aim" }),
      "Aim"
    ] }),
    f("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => ae("solo"), children: f(qe, { name: "solo" }) }),
    f("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => ae("from-lamp"), children: f(qe, { name: "eye" }) }),
    f("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => ae("frame"), children: f(qe, { name: "frame" }) }),
    f("span", { class: "gap" }),
    yt() === null && f("button", { title: "Group (Ctrl+G): one master for all of them", onClick: () => ae("group"), children: "Group" }),
    kt() === null && f("button", { title: a ? "Dissolve the group (Ctrl+Shift+G): its lamps stay" : "Take out of the group (Ctrl+Shift+G)", onClick: () => ae("ungroup"), children: a ? "Dissolve" : "Take out" }),
    f("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((o) => o.parked), onClick: () => ae("park"), children: "Park" }),
    f("button", { class: "icon", "aria-label": `Remove ${Nn(e)}`, title: "Remove (Del)", onClick: () => ae("remove"), children: f(qe, { name: "bin" }) })
  ] });
}
function hs({ ids: e, all: t }) {
  let n = K(t.map((r) => r.level)), a = es(e), o = t.every((r) => r.free), l = e[e.length - 1];
  return D(A, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    D("div", { class: "line slide", children: [
      f("span", { children: "Level" }),
      f(gs, { id: l })
    ] }),
    D("label", { class: "line", children: [
      f("span", {}),
      f(
        rs,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: K(t.map((r) => r.flux)) ?? void 0,
          step: 0.01,
          set: (r) => Rn(e, r),
          open: wo.value,
          opened: () => wo.value = "",
          id: "level"
        }
      )
    ] }),
    f(
      V,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (r) => Rn(e, (s, p) => r(s * p) / p)
      }
    ),
    D("div", { class: "line", children: [
      f("span", { children: "Stops" }),
      f("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: ps.map(([r, s]) => f("button", { "aria-label": `${s} stop`, onClick: () => Rn(e, (p) => Math.min(1e3, p * 2 ** r)), children: s }, s)) })
    ] }),
    D("p", { class: "sum", children: [
      So(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (Nt.get(t[0].group)?.level ?? 1) !== 1 && ` (${qn(t[0].level)} % × ${qn(Nt.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    f(fo, {})
  ] });
}
function gs({ id: e }) {
  let t = cs(null), n = Fn.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (l) => () => {
    t.current?.[l](), t.current = null;
  };
  return f(
    ss,
    {
      label: "Level",
      value: as(n.level),
      text: `${qn(n.level)} %, ${So(n.flux * ts(n), "flux")}`,
      begin: () => t.current = new ls(a),
      on: (l) => t.current ? t.current.to(ko(l)) : xo(a, ko(l)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => xo(a, 1)
    }
  );
}
function Je(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = Fn.get(o), r = n(l.place ?? {}, l);
    r && (a[o] = { place: r });
  }
  Object.keys(a).length && Ft(`${Nn(e)}: ${t}`, { lamps: a });
}
function bs({ ids: e, all: t }) {
  let n = (o) => K(t.map((l) => l.place?.[o] ?? null)), a = (o) => t.some((l) => l.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : D(A, { title: "Beam", note: "re-trace", children: [
    a("outer") && D(Hn, { children: [
      f(V, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => Je(e, "beam", (l) => l.outer == null ? null : { inner: Math.max(0.1, Math.min(l.outer, o(l.inner ?? l.outer))) }) }),
      f(V, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => Je(e, "beam", (l) => {
        if (l.outer == null) return null;
        let r = Math.max(0.2, Math.min(179, o(l.outer)));
        return { outer: r, inner: Math.min(l.inner ?? r, r) };
      }) })
    ] }),
    a("radius") && f(V, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => Je(e, "radius", (l) => l.radius == null ? null : { radius: Math.max(1e-3, o(l.radius)) }) })
  ] });
}
function fs({ ids: e, all: t }) {
  let n = t.filter((c) => vo(c) !== null);
  if (!n.length) return null;
  let a = n.map((c) => vo(c)), o = (c, h) => K(h.map((d) => Math.round(d[c] * 1e4) / 1e4)), l = t.filter((c) => c.place?.direction), r = os.value, s = l.map((c) => Mo(c.place?.direction, r).map((h) => Math.round(h * 10) / 10)), p = t.map((c) => c.place?.aim).filter((c) => !!c), i = (c, h) => {
    let d = ze(e), y = {};
    for (let [v, E] of d) {
      let F = [0, 0, 0];
      F[c] = h(E[c]) - E[c], Object.assign(y, je([v], F, d).lamps);
    }
    Ft(`Move ${Nn(e)}`, { lamps: y });
  }, u = (c, h) => Je(e, c ? "tilt" : "pan", (d) => {
    if (!d.direction) return null;
    let y = Mo(d.direction, r);
    y[c] = h(y[c]);
    let v = ds(y[0], Math.max(-90, Math.min(90, y[1])), r), E = d.aim && d.position ? is(yo(d.aim, d.position)) : 0;
    return { direction: v, ...E && d.position ? { aim: Ht(d.position, Fe(v, E)) } : {} };
  });
  return D(A, { title: "Place", note: "re-trace", children: [
    f(J, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => o(c, a)), set: i }),
    l.length > 0 && D(Hn, { children: [
      f(V, { label: "Pan", quantity: "angle", step: 1, value: K(s.map((c) => c[0])), set: (c) => u(0, c) }),
      f(V, { label: "Tilt", quantity: "angle", step: 1, value: K(s.map((c) => c[1])), set: (c) => u(1, c) }),
      f(
        J,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: p.length ? [0, 1, 2].map((c) => o(c, p)) : [NaN, NaN, NaN],
          set: (c, h) => Je(e, "aim", (d) => {
            if (!d.direction || !d.position) return null;
            let y = ue(d.aim ?? Ht(d.position, Fe(d.direction, 2)), c, h);
            return { aim: y, direction: Co(yo(y, d.position)) };
          })
        }
      )
    ] }),
    D("div", { class: "line", children: [
      f("span", { children: "Handles" }),
      D("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        f("button", { "aria-pressed": Rt.value === "move", onClick: () => Rt.value = "move", children: "Move" }),
        f("button", { "aria-pressed": Rt.value === "turn", onClick: () => Rt.value = "turn", children: "Turn" })
      ] })
    ] }),
    f("button", { class: "plain full", "aria-pressed": Po.value === "place", onClick: () => ae("place"), children: "Put on a surface by pointing" }),
    l.length > 0 && ns.value && f("button", { class: "plain full", onClick: () => ae("aim-here"), children: "Aim at the last point" })
  ] });
}
function vs({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : D(A, { title: "Copies along a line", children: [
    f(V, { label: "How many", quantity: "number", step: 1, value: Re.value, set: (n) => Re.value = Math.max(1, Math.min(100, Math.round(n(Re.value)))) }),
    f(J, { label: "Step", quantity: "length", step: 0.05, value: qt.value, set: (n, a) => qt.value = ue(qt.value, n, a) }),
    D("button", { class: "plain full", onClick: () => bt(e, Re.value, qt.value), children: [
      f(qe, { name: "copy" }),
      Re.value === 1 ? "One copy" : `${Re.value} copies`
    ] })
  ] });
}
function To() {
  let e = Zi.value, t = e.map((s) => Fn.get(s)).filter((s) => !!s);
  if (!t.length) return f("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && Nt.get(n.group), o = $o.value, l = o?.kind === "group" && o.ids.length === 1 ? Nt.get(o.ids[0]) : void 0, r = n?.layer != null ? Ji.value[n.layer] : void 0;
  return D(Hn, { children: [
    f("header", { class: "panel-head", children: l && o ? f(Ie, { label: "Name of the group", value: l.name, set: (s) => Ft(`Rename ${l.name}`, { groups: { [o.ids[0]]: { name: s } } }) }) : n ? f(Ie, { label: "Name of the lamp", value: n.name, set: (s) => Ft(`Rename ${n.name}`, { lamps: { [e[0]]: { name: s } } }) }) : D("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    f("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((s) => s.on).length} of ${t.length} on` }),
    D("div", { class: "scroll", children: [
      f(ms, { ids: e, all: t }),
      l && o && f(A, { title: "Group", note: "re-mix", children: f(V, { label: "Master", name: "Master of the group", quantity: "level", step: 0.01, value: l.level, set: (s) => us(o.ids[0], s) }) }),
      f(hs, { ids: e, all: t }),
      f(A, { title: "Photometry", children: f("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      f(bs, { ids: e, all: t }),
      f(fs, { ids: e, all: t }),
      f(vs, { ids: e, all: t }),
      f("p", { class: "cost", children: t.every((s) => s.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as Gn,
  candles as Dt,
  command as ys,
  digits as Wt,
  edit as Eo,
  Field as Io,
  filterOf as Fo,
  go as ks,
  history as ws,
  hovered as Ao,
  Icon as Kt,
  layers as xs,
  lookOnly as Ro,
  maintenance as Ne,
  materials as Ms,
  percent as Ss,
  scene as Cs,
  select as No,
  signal as $s,
  singleKeys as qo,
  sub as Ls,
  things as Ps,
  travel as Ot,
  Virtual as Ho,
  workPlane as Dn
} from "./desk.js";
import { Fragment as Vs, jsx as x, jsxs as T } from "./desk.js";
function Go() {
  let e = Cs.value;
  if (!e) return null;
  let t = Ls(e.bounds[1], e.bounds[0]);
  return T(Vs, { children: [
    T(A, { title: "Room", children: [
      T("p", { children: [
        t.map((n) => Wt(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${Wt(e.triangles)} triangles` : ""
      ] }),
      x("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && x("ul", { class: "buttons", children: e.cameras.map((n, a) => x("li", { children: x("button", { onClick: () => ks(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && T("details", { children: [
        T("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        x("ul", { class: "remarks", children: e.warnings.map((n) => x("li", { children: n }, n)) })
      ] })
    ] }),
    T(A, { title: "Figures", children: [
      T("label", { class: "line", children: [
        x("span", { children: "Maintenance" }),
        x(Io, { label: "Maintenance factor", quantity: "share", value: Ne.value, step: 0.05, set: (n) => Ne.value = Math.max(0.1, Math.min(1, n(Ne.value))) })
      ] }),
      T("p", { class: "quiet", children: [
        Ne.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Ne.value === 1 && x("button", { class: "plain", onClick: () => Ne.value = 0.8, children: "0.80" })
      ] }),
      T("label", { class: "line", children: [
        x("span", { children: "Work plane" }),
        x(Io, { label: "Work plane above the floor", quantity: "length", value: Dn.value, step: 0.05, set: (n) => Dn.value = Math.max(0, Math.min(3, n(Dn.value))) })
      ] }),
      T("div", { class: "line", children: [
        x("span", { children: "Unit" }),
        T("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          x("button", { "aria-pressed": Dt.value === "lx", onClick: () => Dt.value = "lx", children: "lx, cd/m²" }),
          x("button", { "aria-pressed": Dt.value === "fc", onClick: () => Dt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    x(A, { title: "Layers of light", children: x("ul", { class: "layers", children: xs.value.map((n, a) => T("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      x("i", { class: "dot", "aria-hidden": "true" }),
      x("span", { children: n.name || `layer ${a + 1}` }),
      x("small", { children: n.held ? "held" : Ss(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    T(A, { title: "Hands", children: [
      T("div", { class: "line", children: [
        x("span", { children: "Faders" }),
        T("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          x("button", { "aria-pressed": Ot.value === "square", onClick: () => Ot.value = "square", children: "Square law" }),
          x("button", { "aria-pressed": Ot.value === "linear", onClick: () => Ot.value = "linear", children: "Even" })
        ] })
      ] }),
      T("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: qo.value, onChange: (n) => qo.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      T("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: Ro.value, onChange: (n) => Ro.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var Bt = $s("");
function Do({ label: e }) {
  return x("span", { class: "field filter", children: x("input", { type: "text", "aria-label": e, placeholder: "Filter", value: Bt.value, onInput: (t) => Bt.value = t.currentTarget.value }) });
}
function Oo() {
  let e = Fo(Ps, Bt.value);
  return T("div", { class: "listing", children: [
    x(Do, { label: "Filter things" }),
    x(
      Ho,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return T("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => Ao.value = { kind: "thing", id: n }, onPointerLeave: () => Ao.value = null, children: [
            x("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => Eo(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: x(Kt, { name: a.hidden ? "eye-off" : "eye" }) }),
            x("button", { class: "row-name", onClick: () => No("thing", n), children: x("span", { children: a.name }) }),
            x("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => Eo(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: x(Kt, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function Wo() {
  let e = Fo(Ms, Bt.value);
  return T("div", { class: "listing", children: [
    x(Do, { label: "Filter materials" }),
    x(
      Ho,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return T("div", { class: "sheet-row material", role: "listitem", children: [
            x("button", { class: "row-name", onClick: () => No("material", n), children: x("span", { children: a.name }) }),
            T("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${Wt(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function Ko() {
  let e = ws.value;
  return T(A, { title: "History", children: [
    T("p", { children: [
      e.steps === 1 ? "One step" : `${Wt(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    T("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => Gn("undo"), children: [
      x(Kt, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    T("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => Gn("redo"), children: [
      x(Kt, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    x("button", { class: "plain full", onClick: () => Gn("save"), children: "Save a version with a name…" }),
    x("button", { class: "plain full", onClick: () => ys({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as On,
  edit as jo,
  fromHex as Ts,
  hex as Es,
  Icon as Bo,
  materials as zo,
  middle as Uo,
  select as Xo,
  selection as Qo,
  things as Wn
} from "./desk.js";
import { Fragment as Bn, jsx as L, jsxs as X } from "./desk.js";
var Kn = 180 / Math.PI;
function _o(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * Kn : 0;
}
function Is(e, t) {
  let n = [0, 0, 0, Math.cos(t / Kn / 2)];
  return n[e] = Math.sin(t / Kn / 2), n;
}
function Yo() {
  let e = (Qo.value?.ids ?? []).filter((p) => Wn.get(p)), t = e.map((p) => Wn.get(p));
  if (!t.length) return L("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((p) => p.locked), l = (p, i) => jo(`${a}: ${p}`, { things: Object.fromEntries(e.map((u, c) => [u, i(t[c])])) }), r = t.map((p) => p.place?.position ?? (p.box ? Uo(p.box) : [0, 0, 0])), s = n.box ? [0, 1, 2].map((p) => n.box[1][p] - n.box[0][p]) : null;
  return X(Bn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: a }) }),
    s && X("p", { class: "crumbs", children: [
      s.map((p) => On(p, 2)).join(" × "),
      " m"
    ] }),
    X("div", { class: "scroll", children: [
      X("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        X("button", { "aria-pressed": t.every((p) => p.hidden), onClick: () => l(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          L(Bo, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        X("button", { "aria-pressed": o, onClick: () => l(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          L(Bo, { name: o ? "lock" : "unlock" }),
          o ? "Locked" : "Lock"
        ] })
      ] }),
      X(A, { title: "Place", note: "re-trace", children: [
        o && L("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        L(
          J,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: o,
            value: [0, 1, 2].map((p) => K(r.map((i) => Math.round(i[p] * 1e4) / 1e4))),
            set: (p, i) => l("move", (u) => ({ place: { position: ue(u.place?.position ?? Uo(u.box), p, i) } }))
          }
        ),
        [0, 1, 2].map((p) => L(
          V,
          {
            label: `Turn ${"XYZ"[p]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: K(t.map((i) => Math.round(_o(i.place?.rotation, p) * 10) / 10)),
            set: (i) => l("turn", (u) => ({ place: { rotation: Is(p, i(_o(u.place?.rotation, p))) } }))
          },
          p
        )),
        L(
          V,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: o,
            value: K(t.map((p) => p.place?.scale ?? 1)),
            set: (p) => l("scale", (i) => ({ place: { scale: Math.max(1e-3, p(i.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      L(A, { title: "Materials", children: L("ul", { class: "buttons", children: n.materials.map((p) => L("li", { children: L("button", { onClick: () => Xo("material", p), children: zo.get(p)?.name ?? `material ${p}` }) }, p)) }) })
    ] })
  ] });
}
function Zo() {
  let e = Qo.value?.ids[0], t = zo.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This material is gone." });
  let n = (i, u) => jo(`${t.name}: ${i}`, { materials: { [e]: u } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], r = ((i) => 0.2126 * i[0] + 0.7152 * i[1] + 0.0722 * i[2])(o), s = (i) => o.map((u) => Math.max(0, Math.min(1, r > 1e-4 ? u / r * i : i))), p = (i, u) => t[u] != null && X(Bn, { children: [
    X("div", { class: "line slide", children: [
      L("span", { children: i }),
      L(Ee, { label: i, name: `${t.name}: ${i.toLowerCase()}`, value: t[u], text: On(t[u], 2), patch: (c) => ({ materials: { [e]: { [u]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    L(V, { label: "", name: `${i}, typed`, quantity: "share", step: 0.01, value: t[u], set: (c) => n(i.toLowerCase(), { [u]: Math.max(0, Math.min(1, c(t[u]))) }) })
  ] });
  return X(Bn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: t.name }) }),
    L("p", { class: "crumbs", children: t.kind }),
    X("div", { class: "scroll", children: [
      X(A, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        X("div", { class: "line slide", children: [
          L("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          L(Ee, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: r, text: On(r, 2), patch: (i) => ({ materials: { [e]: { [a]: s(Math.min(0.95, i)) } } }) })
        ] }),
        L(V, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(r * 1e3) / 1e3, set: (i) => n("reflectance", { [a]: s(Math.min(0.98, i(r))) }) }),
        X("label", { class: "line", children: [
          L("span", { children: "Colour" }),
          L("input", { type: "color", class: "pick", "aria-label": "Colour", value: Es(o), onChange: (i) => n("colour", { [a]: Ts(i.currentTarget.value) }) })
        ] }),
        p("Roughness", "roughness"),
        p("Gloss", "specular")
      ] }),
      L(A, { title: "On", children: L("ul", { class: "buttons", children: Wn.all().filter(([, i]) => i.materials.includes(e)).slice(0, 40).map(([i, u]) => L("li", { children: L("button", { onClick: () => Xo("thing", i), children: u.name }) }, i)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as el, jsx as N, jsxs as Ut } from "./desk.js";
var et = ["Scene", "Things", "Materials", "History"], ge = qs("Scene");
function Fs() {
  let e = { Scene: Go, Things: Oo, Materials: Wo, History: Ko }[ge.value];
  return Ut(el, { children: [
    N("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), ge.value = et[(et.indexOf(ge.value) + a + et.length) % et.length], document.getElementById(`tab-${ge.value}`)?.focus());
    }, children: et.map((n) => N("button", { id: `tab-${n}`, role: "tab", "aria-selected": ge.value === n, "aria-controls": "tab-panel", tabIndex: ge.value === n ? 0 : -1, onClick: () => ge.value = n, children: n }, n)) }),
    N("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${ge.value}`, tabIndex: 0, children: N(e, {}) })
  ] });
}
function Ns() {
  let e = Rs.value;
  return e ? Ut(el, { children: [
    Ut("nav", { class: "chooser", "aria-label": "Selection", children: [
      N("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => Jo("previous"), children: N(Un, { name: "back" }) }),
      N("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => Jo("next"), children: N(Un, { name: "forth" }) }),
      N("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      N("span", { class: "gap" }),
      N("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: As, children: N(Un, { name: "close" }) })
    ] }),
    _n.value && N("p", { class: "penless", children: _n.value }),
    Ut("fieldset", { class: "editing", disabled: _n.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && N(To, {}),
      e.kind === "thing" && N(Yo, {}),
      e.kind === "material" && N(Zo, {}),
      e.kind === "meter" && N(po, {}),
      e.kind === "grid" && N(mo, {})
    ] })
  ] }) : N(Fs, {});
}

// src/later/legend.tsx
import { asked as Hs, candles as Gs, display as Ds, Field as Os, show as Ws, three as Ks, useRef as Bs } from "./desk.js";
import { jsx as Q, jsxs as _t } from "./desk.js";
var jn = [1, 2, 5];
function Us(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, l = 10 ** Math.floor(Math.log10(o)), r = l * (jn.find((s) => s * l >= o) ?? 10);
    for (let s = Math.ceil(e / r) * r; s <= t * 1.0001; s += r) a.push(s);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let l of jn) {
      let r = l * 10 ** o;
      r >= e * 0.999 && r <= t * 1.001 && a.push(r);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function _s(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var ce = (e, t) => {
  let n = Hs({ ...e, ...t });
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && Ws({ false_color: n });
};
function tl(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return jn[a] * 10 ** ((n - a) / 3);
}
function js() {
  let e = Ds.value.false_color, t = Bs(null);
  if (!e) return null;
  let n = Gs.value === "fc", a = e.quantity === "illuminance", o = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", l = n ? a ? 1 / 10.7639 : 0.2919 : 1, r = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, s = e.ticks ?? Us(e.low, e.high, e.scale).map((u) => [u, _s(u, e)]), p = (u) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: u, from: e[u] };
    },
    onPointerMove: (c) => {
      let h = t.current;
      h?.end === u && ce(e, { [u]: tl(h.from, Math.round((h.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let h = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      h && (c.preventDefault(), c.stopPropagation(), ce(e, { [u]: tl(e[u], h) }));
    }
  }), i = ({ end: u }) => _t("div", { class: "end", children: [
    Q(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": u === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[u],
        "aria-valuemin": 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${Ks(e[u] * l)} ${o}`,
        ...p(u)
      }
    ),
    Q(
      Os,
      {
        label: u === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[u] * l).toPrecision(3)),
        set: (c) => ce(e, { [u]: c(e[u] * l) / l })
      }
    )
  ] });
  return _t("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    _t("header", { children: [
      Q(
        "button",
        {
          "aria-label": `${o}: ${a ? "illuminance" : "luminance"}, change`,
          onClick: () => ce(e, { quantity: a ? "luminance" : "illuminance" }),
          children: o
        }
      ),
      Q("button", { "aria-pressed": e.scale === "log", onClick: () => ce(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      Q("button", { "aria-pressed": e.lines, onClick: () => ce(e, { lines: !e.lines }), children: "lines" })
    ] }),
    Q(i, { end: "high" }),
    Q("div", { class: "scale", style: { background: r }, children: s.map(([u, c]) => Q("span", { style: { bottom: `${100 * c}%` }, children: String(Number((u * l).toPrecision(2))) }, u)) }),
    Q(i, { end: "low" }),
    _t("footer", { children: [
      Q("button", { onClick: () => ce(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      Q("button", { onClick: () => ce(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      Q(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (u) => ce(e, { palette: u.currentTarget.value }),
          children: e.palettes?.map((u) => Q("option", { children: u }, u)) ?? Q("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as Qn,
  act as sl,
  ask as ou,
  command as lu,
  copyText as ru,
  digits as iu,
  go as su,
  hear as uu,
  lamps as cu,
  say as Qt,
  select as pu,
  send as zt,
  sheet as nt,
  shown as du,
  signal as at,
  useEffect as Yn,
  useLayoutEffect as mu,
  useRef as Yt,
  walkNames as hu,
  whyNotTo as gu
} from "./desk.js";

// src/later/csv.ts
import { gridPoint as zs, grids as Xs, maintenance as Qs, meters as Ys, scene as nl } from "./desk.js";
var Zs = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function Js() {
  let e = Qs.peek(), t = [["scene", nl.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of Ys.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of Xs.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, l] of Object.entries(a)) t.push([o, l == null ? null : l * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, l) => {
      let r = zs(n, l % n.columns, Math.floor(l / n.columns));
      t.push([...r.map((s) => s.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(Zs).join(",")).join(`\r
`) + `\r
`;
}
function zn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function al() {
  let e = URL.createObjectURL(new Blob([Js()], { type: "text/csv" }));
  zn(`${nl.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var rl = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], jt = new Uint8Array(512), Xn = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  jt[e] = jt[e + 255] = t, Xn[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var ol = (e, t) => e && t ? jt[Xn[e] + Xn[t]] : 0;
function eu(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let l = new Array(n.length + 1).fill(0);
    n.forEach((r, s) => {
      l[s] ^= r, l[s + 1] ^= ol(r, jt[o]);
    }), n = l;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let l = a[o];
    l && n.forEach((r, s) => a[o + s] ^= ol(r, l));
  }
  return a.slice(e.length);
}
function tu(e, t) {
  let [n, a, o] = rl[t - 1], l = [], r = (h, d) => {
    for (let y = d - 1; y >= 0; y--) l.push(h >> y & 1);
  };
  for (r(4, 4), r(e.length, 8), e.forEach((h) => r(h, 8)), r(0, Math.min(4, n * 8 - l.length)); l.length % 8; ) l.push(0);
  let s = [];
  for (let h = 0; h < l.length; h += 8) s.push(parseInt(l.slice(h, h + 8).join(""), 2));
  for (let h = 236; s.length < n; h ^= 253) s.push(h);
  let p = n / o, i = Array.from({ length: o }, (h, d) => s.slice(d * p, (d + 1) * p)), u = i.map((h) => eu(h, a)), c = (h) => h[0].flatMap((d, y) => h.map((v) => v[y]));
  return [...c(i), ...c(u)];
}
var nu = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function au(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function ll(e) {
  let t = e.length, n = 0, a = 0;
  for (let o of [!1, !0])
    for (let l = 0; l < t; l++) {
      let r = Array.from({ length: t }, (i, u) => o ? e[u][l] : e[l][u]), s = 1;
      for (let i = 1; i <= t; i++)
        i < t && r[i] === r[i - 1] ? s++ : (s >= 5 && (n += s - 2), s = 1);
      let p = r.map(Number).join("");
      for (let i = 0; i + 11 <= t; i++) {
        let u = p.slice(i, i + 11);
        (u === "10111010000" || u === "00001011101") && (n += 40);
      }
    }
  for (let o = 0; o < t; o++)
    for (let l = 0; l < t; l++)
      e[o][l] && a++, l && o && e[o][l] === e[o - 1][l] && e[o][l] === e[o][l - 1] && e[o][l] === e[o - 1][l - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function il(e) {
  let t = [...new TextEncoder().encode(e)], n = rl.findIndex(([d]) => t.length + 2 <= d) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), l = Array.from({ length: a }, () => new Array(a).fill(!1)), r = (d, y, v) => {
    d < 0 || y < 0 || d >= a || y >= a || (o[y][d] = v, l[y][d] = !0);
  };
  for (let d = 0; d < a; d++)
    r(d, 6, d % 2 === 0), r(6, d, d % 2 === 0);
  for (let [d, y] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let v = -4; v <= 4; v++)
      for (let E = -4; E <= 4; E++) {
        let F = Math.max(Math.abs(E), Math.abs(v));
        r(d + E, y + v, F !== 2 && F !== 4);
      }
  if (n > 1) {
    let d = a - 7;
    for (let y = -2; y <= 2; y++) for (let v = -2; v <= 2; v++) r(d + v, d + y, Math.max(Math.abs(v), Math.abs(y)) !== 1);
  }
  let s = (d) => {
    let y = au(d);
    for (let v = 0; v < 15; v++) {
      let E = (y >> v & 1) === 1, F = v < 6 ? v : v < 8 ? v + 1 : a - 15 + v;
      r(8, F, E), r(v < 8 ? a - 1 - v : v < 9 ? 7 : 14 - v, 8, E);
    }
    r(8, a - 8, !0);
  };
  s(0);
  let p = tu(t, n), i = 0;
  for (let d = a - 1; d > 0; d -= 2) {
    d === 6 && (d = 5);
    for (let y = 0; y < a; y++)
      for (let v of [d, d - 1]) {
        let F = (d + 1 & 2) === 0 ? a - 1 - y : y;
        l[F][v] || (o[F][v] = i < p.length * 8 && (p[i >> 3] >> 7 - (i & 7) & 1) === 1, i++);
      }
  }
  let u = (d) => (s(d), o.map((y, v) => y.map((E, F) => E !== (!l[v][F] && nu[d](F, v))))), c = u(0), h = ll(c);
  for (let d = 1; d < 8; d++) {
    let y = u(d), v = ll(y);
    v < h && ([c, h] = [y, v]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as Cu, jsx as g, jsxs as P } from "./desk.js";
function ot({ title: e, wide: t, children: n }) {
  let a = Yt(null);
  mu(() => {
    let l = a.current, r = document.activeElement;
    return l.open || l.showModal(), () => r?.focus();
  }, []);
  let o = () => nt.value = null;
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
var bu = [
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
function fu() {
  let e = [...new Set(Qn().map((t) => t.group))];
  return g(ot, { title: "All keys", wide: !0, children: P("div", { class: "help", children: [
    P("table", { children: [
      g("caption", { class: "spoken", children: "By hand" }),
      g("thead", { children: P("tr", { children: [
        g("th", { scope: "col", children: "What" }),
        g("th", { scope: "col", children: "Mouse" }),
        g("th", { scope: "col", children: "Keys, in the view" }),
        g("th", { scope: "col", children: "Fingers" })
      ] }) }),
      g("tbody", { children: bu.map(([t, n, a, o]) => P("tr", { children: [
        g("th", { scope: "row", children: t }),
        g("td", { children: n }),
        g("td", { children: a.replace("walking keys", hu.value) }),
        g("td", { children: o })
      ] }, t)) })
    ] }),
    P("div", { class: "columns", children: [
      e.map((t) => P("section", { children: [
        g("h3", { children: t }),
        g("dl", { children: Qn().filter((n) => n.group === t && n.keys).map((n) => P(Cu, { children: [
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
var Xt = at(""), tt = at(0);
function vu() {
  let e = Xt.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = Qn().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: gu(a.id), run: () => sl(a.id) }));
  for (let { name: a, camera: o } of Mt())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => su(o, a) });
  if (e.length)
    for (let [a, o] of cu.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => pu("lamp", a) });
    }
  return n.slice(0, 60);
}
function yu() {
  let e = vu(), t = Math.min(tt.value, e.length - 1);
  Yn(() => {
    Xt.value = "", tt.value = 0;
  }, []), Yn(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (nt.value = null, a.why ? Qt(a.why, "warn") : setTimeout(a.run, 0));
  };
  return P(ot, { title: "Command palette", children: [
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
        value: Xt.value,
        onInput: (a) => {
          Xt.value = a.currentTarget.value, tt.value = 0;
        },
        onKeyDown: (a) => {
          let o = { ArrowDown: 1, ArrowUp: -1 }[a.key];
          o && (a.preventDefault(), tt.value = (t + o + e.length) % Math.max(1, e.length)), a.key === "Enter" && (a.preventDefault(), n(e[t]));
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
          onPointerMove: () => tt.value = o,
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
var ul = at([]);
uu("links", (e) => ul.value = e.links);
function ku({ text: e }) {
  let t = il(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, l) => o.map((r, s) => r ? `M${s + 4} ${l + 4}h1v1h-1z` : "").join("")).join("");
  return P("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    g("rect", { width: n, height: n, fill: "#fff" }),
    g("path", { d: a, fill: "#000" })
  ] });
}
function wu() {
  let e = at(null), t = Yt(e).current;
  return Yn(() => {
    zt({ do: "links", what: "list" });
  }, []), P(ot, { title: "Share by link", children: [
    g("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    g("ul", { class: "links", children: ul.value.map((n) => P("li", { children: [
      g("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      g("code", { children: n.address }),
      P("span", { class: "buttons", children: [
        g("button", { onClick: () => {
          ru(n.address);
        }, children: "Copy" }),
        g("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        g("button", { onClick: () => zt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && g(ku, { text: n.address })
    ] }, n.id)) }),
    P("footer", { children: [
      g("button", { onClick: () => zt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      g("button", { onClick: () => zt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function xu() {
  let e = Yt(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    lu({ do: "save", name: n }), nt.value = null, Qt(`Saving the version “${n}”.`);
  };
  return P(ot, { title: "Save a version", children: [
    g("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    P("label", { class: "line", children: [
      g("span", { children: "Name" }),
      g("span", { class: "field", children: g("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    g("footer", { children: g("button", { onClick: t, children: "Save" }) })
  ] });
}
var te = at(null);
function Mu() {
  let e = du.value?.head, t = Yt(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    te.value = 0;
    let [o, l] = [Number(n("width")), Number(n("height"))];
    ou("picture", { format: n("format"), width: o, height: l, batches: Number(n("batches")) }, (r) => {
      r.why ? (te.value = null, Qt(r.why, "warn")) : r.url ? (te.value = null, zn(r.name, r.url), nt.value = null) : te.value = r.progress ?? 0;
    }, (r) => {
      te.value = null, Qt(r, "warn");
    });
  };
  return P(ot, { title: "Save the picture", children: [
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
      g("button", { onClick: () => sl("command"), children: "Copy the command" }),
      g("button", { disabled: te.value !== null, onClick: a, children: te.value === null ? "Render and save" : te.value ? `${iu(te.value * 100)} %` : "Rendering…" })
    ] })
  ] });
}
function Su() {
  switch (nt.value) {
    case "help":
      return g(fu, {});
    case "palette":
      return g(yu, {});
    case "share":
      return g(wu, {});
    case "save":
      return g(xu, {});
    case "picture":
      return g(Mu, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import {
  act as $u,
  colorText as cl,
  cost as Lu,
  css as Pu,
  Field as Vu,
  groups as Tu,
  hovered as Zt,
  Icon as Eu,
  lamps as Iu,
  lumensOf as Au,
  penless as Ru,
  pickRow as qu,
  select as Fu,
  selection as pl,
  switchOn as Nu,
  three as Hu,
  typeGroupLevel as Gu,
  typeLevel as Du
} from "./desk.js";
import { jsx as Y, jsxs as Zn } from "./desk.js";
function Ou() {
  return Zn("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    Y("span", {}),
    Y("span", { children: "Name" }),
    Y("span", { children: "Level" }),
    Y("span", { children: "lm" }),
    Y("span", { children: "White" })
  ] });
}
function Wu({ row: e, index: t, count: n }) {
  let a = e.kind === "lamp" ? Iu.get(e.id) : void 0, o = e.kind === "group" ? Tu.get(e.id) : void 0, l = a ?? o;
  if (!l) return null;
  let r = pl.value?.kind === e.kind && pl.value.ids.includes(e.id), s = Au(o?.lamps ?? [e.id]), p = Ru.value, i = Zt.value?.kind === e.kind && Zt.value.id === e.id;
  return Zn(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${r ? "selected" : ""} ${l.on ? "" : "off"} ${i ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => Zt.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => Zt.value = null,
      children: [
        Y("button", { class: "icon power", "aria-pressed": l.on, disabled: p !== null, title: p ?? void 0, "aria-label": `${l.name} on`, onClick: () => Nu(e, !l.on), children: Y(Eu, { name: "power" }) }),
        Y("button", { class: "row-name", "aria-pressed": r, title: a ? Lu(a) : void 0, onClick: (u) => qu(u, e.kind, e.id), onDblClick: () => $u("frame"), children: Y("span", { children: l.name }) }),
        Y(
          Vu,
          {
            label: `${l.name} level`,
            quantity: "level",
            value: l.level,
            flux: a?.flux,
            step: 0.01,
            disabled: p !== null,
            why: p,
            set: (u) => a ? Du([e.id], u) : Gu(e.id, u)
          }
        ),
        Y("span", { class: "lumens", children: Hu(s) }),
        a ? Zn("button", { class: "tint", "aria-label": `${l.name} colour: ${cl(a)}`, onClick: () => Fu("lamp", e.id), children: [
          Y("i", { class: "swatch", style: { background: Pu(a.swatch) } }),
          cl(a)
        ] }) : Y("span", {})
      ]
    }
  );
}

// src/later/strip.tsx
import {
  act as Jn,
  command as bl,
  digits as ea,
  fade as Jt,
  Field as Ku,
  grids as dl,
  Icon as He,
  looks as ml,
  luxText as be,
  maintenance as Bu,
  meters as hl,
  select as gl,
  selection as en,
  signal as Uu,
  storeLook as _u
} from "./desk.js";
import { Fragment as Yu, jsx as M, jsxs as H } from "./desk.js";
var ta = Uu("looks");
function ju() {
  return H("section", { class: "looks", "aria-label": "Looks", children: [
    H("header", { children: [
      M("h2", { children: "Looks" }),
      M("button", { class: "tab", onClick: () => ta.value = "meters", children: "Meters" }),
      M("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: _u, children: M(He, { name: "plus" }) }),
      M("span", { class: "gap" }),
      H("label", { class: "tint", children: [
        "Fade",
        M(Ku, { label: "Cross-fade", quantity: "seconds", value: Jt.value, step: 0.5, set: (e) => Jt.value = Math.max(0, e(Jt.value)) })
      ] })
    ] }),
    H("ul", { children: [
      ml.all().map(([e, t], n) => H("li", { class: "look", children: [
        H("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => bl({ do: "look", id: e, what: "recall", seconds: Jt.peek() }), children: [
          t.picture && M("img", { src: t.picture, alt: "" }),
          M("span", { children: t.name })
        ] }),
        M(zu, { id: e, name: t.name })
      ] }, e)),
      !ml.ids.value.length && M("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function zu({ id: e, name: t }) {
  let n = `look-${e}`, a = (s) => {
    let p = s.getBoundingClientRect(), i = document.getElementById(n);
    i?.style.setProperty("left", `${Math.min(p.left, innerWidth - 296)}px`), i?.style.setProperty("bottom", `${innerHeight - p.top + 4}px`), i?.style.setProperty("top", "auto");
  }, o = { popovertarget: n }, l = () => document.getElementById(n)?.hidePopover(), r = (s, p = {}) => {
    l(), bl({ do: "look", id: e, what: s, ...p });
  };
  return H(Yu, { children: [
    M("button", { class: "icon more", ...o, "aria-label": `More of ${t}`, onPointerDown: (s) => a(s.currentTarget), onFocus: (s) => a(s.currentTarget), children: M(He, { name: "more" }) }),
    H("div", { id: n, popover: "auto", class: "menu", children: [
      H("label", { class: "line", children: [
        M("span", { children: "Name" }),
        M("span", { class: "field", children: M("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (s) => r("rename", { name: s.currentTarget.value }) }) })
      ] }),
      M("button", { class: "item", onClick: () => r("update"), children: M("span", { children: "Update to what is set now" }) }),
      M("button", { class: "item", onClick: () => r("recall", { seconds: 0 }), children: M("span", { children: "Recall at once" }) }),
      M("button", { class: "item", onClick: () => r("remove"), children: M("span", { children: "Remove" }) })
    ] })
  ] });
}
function Xu() {
  let e = Bu.value;
  return H("section", { class: "readings", "aria-label": "Meters and grids", children: [
    H("header", { children: [
      M("h2", { children: "Meters" }),
      M("button", { class: "tab", onClick: () => ta.value = "looks", children: "Looks" }),
      M("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => Jn("meter-tool"), children: M(He, { name: "meter" }) }),
      M("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => Jn("grid"), children: M(He, { name: "grid" }) }),
      M("button", { onClick: () => Jn("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      M("button", { onClick: al, title: "Save all figures as CSV", children: "CSV" }),
      M("span", { class: "gap" }),
      M("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${ea(e, 2)} maintained` })
    ] }),
    H("ul", { children: [
      hl.all().map(([t, n]) => {
        let a = n.lux;
        return M("li", { children: H("button", { class: "reading", "aria-pressed": en.value?.kind === "meter" && en.value.ids.includes(t), onClick: () => gl("meter", t), children: [
          H("span", { class: "tint", children: [
            M(He, { name: "meter" }),
            n.name,
            " ",
            M(Cn, { of: Vt(n) })
          ] }),
          M("strong", { class: Lt(n) ? "unsettled" : "", children: a ? be(a[0] * e) : "…" }),
          H("small", { children: [
            a?.[1] != null ? `±${be(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind,
            n.target ? ` · wants ${be(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      dl.all().map(([t, n]) => {
        let a = n.target;
        return M("li", { children: H("button", { class: "reading", "aria-pressed": en.value?.kind === "grid" && en.value.ids.includes(t), onClick: () => gl("grid", t), children: [
          H("span", { class: "tint", children: [
            M(He, { name: "grid" }),
            n.name,
            " ",
            M(Cn, { of: Tt(n) })
          ] }),
          M("strong", { class: Pt(n) ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${be(n.mean * e)}${n.error == null ? "" : ` ±${be(n.error * e, !1)}`}` }),
          H("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : ea(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : be(n.min * e, !1),
            " to",
            " ",
            n.max == null ? "…" : be(n.max * e, !1),
            a ? ` · wants ${be(a.lux)}, U₀ ${ea(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !hl.ids.value.length && !dl.ids.value.length && M("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Qu() {
  return H("div", { class: "strip-parts", "data-tab": ta.value, children: [
    M(ju, {}),
    M(Xu, {})
  ] });
}

// src/later/menus.tsx
import {
  camera as yl,
  digits as kl,
  display as Zu,
  Field as nn,
  go as wl,
  houseLights as na,
  Item as $e,
  Range as Ju,
  show as aa,
  theme as fl,
  walking as ec
} from "./desk.js";
import { Fragment as an, jsx as C, jsxs as ne } from "./desk.js";
var tn = Math.PI / 360;
function vl(e) {
  let t = yl.peek();
  t && wl({ ...t, fov: Math.max(3, Math.min(140, e)) });
}
function tc() {
  let e = yl.value, t = Mt();
  return ne(an, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((n) => C($e, { id: n }, n)),
    C("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((n) => C($e, { id: `preset-${n}` }, n)),
    C("hr", {}),
    t.length > 0 && C("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    t.map(({ name: n, camera: a }, o) => C("button", { class: "item", onClick: () => wl(a, n), children: C("span", { children: n }) }, o)),
    t.length > 0 && C("hr", {}),
    e && !e.height && ne(an, { children: [
      ne("label", { class: "line", children: [
        C("span", { children: "Angle" }),
        C(nn, { label: "Vertical angle of view", quantity: "angle", value: e.fov, step: 1, set: (n) => vl(n(e.fov)) })
      ] }),
      ne("label", { class: "line", children: [
        C("span", { children: "Focal length" }),
        C(nn, { label: "Focal length on 36 × 24 mm", quantity: "number", value: Math.round(120 / Math.tan(e.fov * tn)) / 10, text: `${kl(12 / Math.tan(e.fov * tn), 1)} mm`, step: 1, set: (n) => vl(Math.atan(12 / Math.max(2, n(12 / Math.tan(e.fov * tn)))) / tn) })
      ] }),
      C("hr", {})
    ] }),
    C($e, { id: "walking", label: ec.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    C($e, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((n) => C($e, { id: `hands-${n}` }, n))
  ] });
}
var nc = ["linear", "reinhard", "filmic"];
function ac() {
  let e = Zu.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return ne(an, { children: [
    ne("fieldset", { children: [
      C("legend", { children: "Tone curve" }),
      C("div", { class: "segments", children: nc.map((n) => C("button", { "aria-pressed": e.tone === n, onClick: () => aa({ tone: n }), children: n }, n)) })
    ] }),
    ne("fieldset", { children: [
      C("legend", { children: "White balance" }),
      ne("label", { class: "line", children: [
        C("span", { children: "White" }),
        C(nn, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => aa({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      ne("label", { class: "line", children: [
        C("span", { children: "Tint" }),
        C(nn, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => aa({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    C("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => C($e, { id: n }, n))
  ] });
}
function oc() {
  return ne(an, { children: [
    ne("label", { class: "line", children: [
      C("span", { children: "House lights" }),
      C(Ju, { label: "House lights", value: na.value, text: `${kl(na.value * 100)} %`, on: (e) => na.value = Math.max(0.3, e) })
    ] }),
    C("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => C("button", { "aria-pressed": fl.value === e, onClick: () => fl.value = e, children: e }, e)) }),
    C("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => C($e, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as on, cut as lc, digits as xl, edit as Ml, go as rc, Icon as lt, Range as ic, setCut as sc, signal as uc, storeView as cc, viewName as pc, views as dc } from "./desk.js";
import { jsx as W, jsxs as oa } from "./desk.js";
var ln = uc(null);
function mc() {
  let e = dc.all();
  return oa("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    W("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => on("home"), children: W(lt, { name: "home" }) }),
    W("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => on("frame"), children: W(lt, { name: "frame" }) }),
    W("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => on("back"), children: W(lt, { name: "back" }) }),
    W("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => on("forth"), children: W(lt, { name: "forth" }) }),
    W("span", { class: "divide" }),
    e.map(([t, n], a) => ln.value === t ? W("span", { class: "field", children: W(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (o) => o?.focus(),
        onBlur: (o) => {
          let l = o.currentTarget.value.trim();
          ln.value = null, l && l !== n.name && Ml(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (o) => {
          o.stopPropagation(), o.key === "Escape" && (o.currentTarget.value = n.name ?? ""), (o.key === "Enter" || o.key === "Escape") && o.currentTarget.blur();
        }
      }
    ) }, t) : oa(
      "button",
      {
        class: "saved-view",
        "aria-pressed": pc.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click or F2 renames, Delete removes`,
        onClick: () => rc(n, n.name ?? "view"),
        onDblClick: () => ln.value = t,
        onKeyDown: (o) => {
          o.key === "F2" && (ln.value = t), o.key === "Delete" && (o.stopPropagation(), Ml(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          W("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    W("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: cc, children: W(lt, { name: "plus" }) })
  ] });
}
function hc() {
  let e = lc.value;
  if (!e) return null;
  let t = e.height === null ? `${xl(e.value, 2)} m` : `at ${xl(e.height, 2)} m`;
  return oa("label", { class: "cut", "data-scroll": !0, children: [
    W("span", { children: "Cut" }),
    W(
      ic,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => sc(n * e.most)
      }
    ),
    W("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as gc, useRef as bc } from "./desk.js";
import { jsx as Sl } from "./desk.js";
function fc() {
  let e = bc(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let l = a.getBoundingClientRect(), r = (i) => Math.max(-1, Math.min(1, i)), s = o ? 0 : r((n.clientX - l.left) / (l.width / 2) - 1), p = o ? 0 : r(1 - (n.clientY - l.top) / (l.height / 2));
    e.current?.style.setProperty("transform", `translate(${s * 28}px, ${-p * 28}px)`), gc(p, s);
  };
  return Sl("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: Sl("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as Cl,
  closeWhat as $l,
  digits as vc,
  hovered as Ll,
  Icon as yc,
  lamps as kc,
  luxText as fe,
  nameOf as wc,
  select as xc,
  useEffect as Mc,
  useRef as Sc,
  viewSize as Cc,
  what as $c
} from "./desk.js";
import { jsx as B, jsxs as oe } from "./desk.js";
var Le = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], Lc = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function Pc() {
  let e = $c.value, t = Sc(null);
  if (Mc(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = Cc.value, o = [...e.lamps].sort((c, h) => Le(h) - Le(c)), l = o.reduce((c, h) => c + Le(h), 0) || 1, r = o.slice(0, 9), s = l - r.reduce((c, h) => c + Le(h), 0), p = Math.max(8, Math.min(e.x + 12, n - 332)), i = Math.max(8, Math.min(e.y + 12, a - 150 - 35 * r.length)), u = e.lux ? `${fe(e.lux[0])} ±${fe(e.lux[1], !1)}` : "Measuring…";
  return oe(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${p}px`, top: `${i}px` },
      onKeyDown: (c) => {
        c.key === "Escape" && (c.stopPropagation(), $l(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        oe("header", { children: [
          B("strong", { class: e.done ? "" : "unsettled", children: u }),
          B("span", { class: "quiet", children: "what lights this" }),
          B("button", { class: "icon", "aria-label": "Close", onClick: $l, children: B(yc, { name: "close" }) })
        ] }),
        oe("ol", { children: [
          r.map((c) => B(
            "li",
            {
              onPointerEnter: () => Ll.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => Ll.value = null,
              children: oe("button", { class: "row", onClick: () => xc("lamp", c.id), children: [
                B("span", { class: "name", children: wc("lamp", c.id) }),
                oe("span", { class: "figure", children: [
                  vc(100 * Le(c) / l, Le(c) / l < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                oe("span", { class: "figure lux", children: [
                  fe(Le(c)),
                  " ±",
                  fe(Lc(c), !1)
                ] }),
                oe("span", { class: "shares", "aria-hidden": "true", children: [
                  B("i", { class: "direct", style: { width: `${100 * c.direct[0] / l}%` } }),
                  B("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / l}%` } }),
                  B("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / l}%` } })
                ] }),
                oe("span", { class: "spoken", children: [
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
          o.length > r.length && oe("li", { class: "quiet", children: [
            o.length - r.length === 1 ? "one more" : `${o.length - r.length} more together`,
            ": ",
            fe(s)
          ] }),
          !o.length && B("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        oe("footer", { children: [
          B("span", { class: "key direct", children: "direct" }),
          B("span", { class: "key indirect", children: "indirect" }),
          B("span", { class: "key caustic", children: "caustic" }),
          B("span", { class: "gap" }),
          Cl.value.some((c) => kc.get(c)?.place?.direction) && B("button", { onClick: () => Be(Cl.peek(), e.hit.point), children: "Aim here" }),
          B("button", { onClick: () => _e(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Kr as Compare,
  hc as CutBar,
  Ci as Gizmo,
  Ns as Inspector,
  js as Legend,
  oc as PageItems,
  ac as SeeingItems,
  Ou as SheetHead,
  Wu as SheetRow,
  Su as Sheets,
  Qu as Strip,
  tc as ViewItems,
  mc as ViewStrip,
  fc as WalkPad,
  Pc as What
};
