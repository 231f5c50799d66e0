// src/later/actions.ts
import {
  addMeter as fl,
  adding as vl,
  aim as yl,
  ask as kl,
  back as wl,
  candles as xn,
  chosenLamps as ue,
  clearSolo as xl,
  command as Mn,
  compareHeld as Ml,
  copyAlong as Cl,
  copyText as Sl,
  deselect as $l,
  each as Et,
  edit as Vt,
  exposeBy as Cn,
  falseColor as Ll,
  fine as Sn,
  forth as Pl,
  frameSelection as Tl,
  go as El,
  goHome as Vl,
  goInside as Al,
  goPreset as Il,
  handles as $n,
  hands as ql,
  here as Rl,
  highlight as Fl,
  history as Ln,
  lampMarks as Pn,
  lamps as Je,
  listing as Tn,
  lookOnly as En,
  panels as Vn,
  PRESETS as Hl,
  register as Nl,
  removeLamps as Dl,
  say as Ze,
  scene as Ol,
  selection as Hn,
  send as Wl,
  sheet as De,
  show as Gl,
  soloSelection as Bl,
  spot as Oe,
  startTool as xe,
  stepSelection as An,
  storeLook as Kl,
  storeView as Ul,
  theme as In,
  things as qn,
  titleOf as Nn,
  toggleFalse as _l,
  toggleWipe as zl,
  travel as Rn,
  views as Xl,
  walking as Tt,
  whyNot as Z
} from "./desk.js";
var se = () => Z() ?? (ue.value.length ? null : "Select a lamp first.");
function Ql() {
  let e = ue.peek(), t = !e.some((n) => Je.get(n)?.on);
  Vt(`${Nn(e)} ${t ? "on" : "off"}`, { lamps: Et(e, { on: t }) });
}
function Yl() {
  let e = ue.peek(), t = !e.every((n) => Je.get(n)?.parked);
  Vt(`${t ? "Park" : "Unpark"} ${Nn(e)}`, { lamps: Et(e, { parked: t }) });
}
function Fn(e) {
  let t = Hn.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : qn.ids.peek().filter((a) => qn.get(a)?.hidden);
  if (!n.length) return Ze(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Vt(e ? "Hide things" : "Show hidden things", { things: Et(n, { hidden: e }) });
}
function jl() {
  let e = ue.peek()[0], t = Je.get(e)?.place, n = Rl();
  if (!t?.position || !t.direction || !n) return Ze("Select a lamp that has a direction.", "warn");
  let { position: a, direction: l } = t;
  El({ ...n, eye: a, target: [a[0] + l[0], a[1] + l[1], a[2] + l[2]], height: null, near: null }, "from the lamp");
}
function Zl() {
  kl("command", {}, (e) => {
    Sl(e.text);
  });
}
var Jl = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], eo = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, to = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: Tl },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: Vl },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: Al },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: wl },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: Pl },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Ul, why: Z },
  ...Hl.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: eo[e],
    keys: `Shift+${t + 1}`,
    run: () => Il(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      Tt.value = Tt.peek() === "walk" ? "fly" : "walk", Ze(Tt.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: jl, why: se },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => An(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => An(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => xe("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => Hn.value = { kind: "lamp", ids: Je.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: $l },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: Ql, why: se },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Bl, why: () => ue.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: xl },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => Fl(!0), why: se },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Yl, why: se },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => xe("aim"), why: se },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => Oe.peek() && yl(ue.peek(), Oe.peek().point), why: se },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => $n.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => $n.value = "turn" },
  ...Jl.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: Z,
    run: () => {
      vl.value = e, xe("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => Cl(ue.peek(), 1, [0.5, 0, 0]), why: se },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => Dl(ue.peek()), why: se },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => Fn(!0), why: Z },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => Fn(!1), why: Z },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => Mn({ do: "undo" }), why: () => Z() ?? (Ln.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => Mn({ do: "redo" }), why: () => Z() ?? (Ln.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => De.value = "save", why: Z },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => De.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Zl },
  { id: "share", group: "Work", label: "Share by link", run: () => De.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: _l },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = Ll();
      Gl({ false_color: { ...e, quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => Cn(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => Cn(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => Wl({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => Ml(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: zl },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: Z, run: () => Oe.peek() ? fl(Oe.peek().point, Oe.peek().normal) : xe("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => xe("meter"), why: Z },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => xe("grid"), why: Z },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => xn.value = xn.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Kl, why: Z },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => Ze("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => Vn.value = !Vn.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => Tn.value = Tn.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => Rn.value = Rn.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => Pn.value = !Pn.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => Sn.value = !Sn.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => In.value = In.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => En.value = !En.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => ql.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => De.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => De.value = "palette" }
];
Nl(to);
function et() {
  return [...(Ol.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...Xl.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as no, comparing as ao, digits as lo, fitted as oo, useEffect as ro, useRef as io, viewSize as so, wipeAt as At } from "./desk.js";
import { Fragment as co, jsx as It, jsxs as po } from "./desk.js";
function uo() {
  let e = ao.value, t = no.value, n = io(null);
  if (ro(() => {
    let s = n.current;
    !s || !t || (s.width = t.picture.width, s.height = t.picture.height, s.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = so.value, l = At.value, r = oo(t.picture.width, t.picture.height), o = Math.max(0, Math.min(1, (l * a - r.x) / (t.picture.width * r.scale))), i = (s) => {
    let p = s.currentTarget;
    if (s.stopPropagation(), s.type === "pointerdown") p.setPointerCapture(s.pointerId);
    else if (p.hasPointerCapture(s.pointerId)) {
      let u = p.parentElement.getBoundingClientRect();
      At.value = Math.max(0, Math.min(1, (s.clientX - u.left) / u.width));
    }
  }, c = (s) => {
    let p = { ArrowLeft: -0.02, ArrowRight: 0.02 }[s.key];
    p && (s.stopPropagation(), s.preventDefault(), At.value = Math.max(0, Math.min(1, l + p)));
  };
  return po(co, { children: [
    It(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * o}% 0 0)` : "none" }
      }
    ),
    It("span", { class: "tag left", children: "before" }),
    e === "wipe" && It(
      "div",
      {
        class: "wipe",
        "data-handle": "wipe",
        role: "slider",
        tabIndex: 0,
        "aria-label": "Wipe between before and now",
        "aria-valuemin": 0,
        "aria-valuemax": 100,
        "aria-valuenow": Math.round(l * 100),
        "aria-valuetext": `${lo(l * 100)} % before`,
        style: { left: `${100 * l}%` },
        onPointerDown: i,
        onPointerMove: i,
        onKeyDown: c
      }
    )
  ] });
}

// src/later/handles.tsx
import {
  add as Kn,
  chosenLamps as wo,
  computed as Ft,
  editor as xo,
  effect as Mo,
  fitted as Co,
  Gesture as So,
  handles as $o,
  lamps as nt,
  lookOnly as Lo,
  middle as Po,
  nameOf as To,
  normal as Eo,
  pinhole as Vo,
  placed as Ao,
  positionOf as _n,
  positions as Io,
  role as qo,
  selection as Ro,
  shown as Fo,
  sub as Ho,
  things as at,
  titleOf as No,
  tool as Do,
  turn as Un,
  useEffect as Oo,
  useRef as Wo,
  viewSize as Go
} from "./desk.js";

// src/later/gizmo.ts
import { project as Dn, ray as mo } from "./desk.js";
import { across as ho, add as te, cross as bo, distance as go, dot as ce, length as fo, normal as qt, scale as ne, sub as Me } from "./desk.js";
var vo = "http://www.w3.org/2000/svg", Rt = 84, ge = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], tt = ["x", "y", "z"], On = 0.1, yo = 5 * Math.PI / 180, Wn = 48;
function Bn(e, t) {
  let n = (m, b, k) => {
    let w = document.createElementNS(vo, m);
    return w.setAttribute("class", k), b.append(w), w;
  }, a = (m, b, k) => {
    let w = n("g", e, `handle ${m} ${tt[b] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, l = n("path", e, "aim-line"), r = ge.map((m, b) => a("ring", b, `ring-${tt[b]}`)), o = ge.map((m, b) => a("plane", b, `plane-${tt[b]}`)), i = ge.map((m, b) => a("arrow", b, `move-${tt[b]}`)), c = a("centre", -1, "move-view"), s = a("aim", -1, "aim"), p = n("text", e, "handle-text"), u = (m, b) => {
    let [k, w, T] = Dn(m.hole, b);
    return T < 0.02 && !m.hole.parallel ? null : [m.fit.x + k * m.fit.scale, m.fit.y + w * m.fit.scale];
  }, g = (m, b) => {
    let k = Dn(m.hole, b)[2];
    return Rt / m.fit.scale * m.hole.pixel * (m.hole.parallel ? 1 : Math.max(k, 0.02));
  }, d = (m, b, k = !1) => {
    let w = b.filter((C) => C !== null), T = w.length < b.length || w.length < 2 ? "" : `M${w.map((C) => `${C[0].toFixed(1)} ${C[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    m.setAttribute("d", T);
  }, f = (m, b, k) => {
    m.setAttribute("d", b ? `M${b[0] - k} ${b[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, v = (m, b) => m.forEach((k) => k.group.classList.toggle("gone", !b));
  function V(m, b) {
    let k = m.position, w = u(b, k), T = g(b, k), C = m.mode === "move";
    v([...i, ...o, c], C && w !== null), v(r, !C && w !== null && m.turns);
    let z = m.aim ?? (m.direction ? te(k, ne(m.direction, 3 * T)) : null);
    if (v([s], z !== null && w !== null), !w) {
      l.setAttribute("d", "");
      return;
    }
    ge.forEach((O, K) => {
      let I = u(b, te(k, ne(O, T))), Qe = I ? Math.hypot(I[0] - w[0], I[1] - w[1]) < 12 : !0;
      if (i[K].group.classList.toggle("gone", !C || Qe), I && C) {
        let [be, He] = [(I[0] - w[0]) / Rt, (I[1] - w[1]) / Rt], je = Math.hypot(be, He) || 1, [ie, Ne] = [be / je, He / je], Pt = [w[0] + 14 * ie, w[1] + 14 * Ne];
        d(i[K].hit, [Pt, I]), i[K].seen.setAttribute("d", `M${Pt[0].toFixed(1)} ${Pt[1].toFixed(1)}L${I[0].toFixed(1)} ${I[1].toFixed(1)}M${(I[0] - 9 * ie - 4.5 * Ne).toFixed(1)} ${(I[1] - 9 * Ne + 4.5 * ie).toFixed(1)}L${I[0].toFixed(1)} ${I[1].toFixed(1)}L${(I[0] - 9 * ie + 4.5 * Ne).toFixed(1)} ${(I[1] - 9 * Ne - 4.5 * ie).toFixed(1)}`);
      }
      let [Re, Fe] = [ge[(K + 1) % 3], ge[(K + 2) % 3]], j = Math.abs(ce(O, b.hole.parallel ? b.hole.forward : qt(Me(k, b.hole.eye)))) < 0.15;
      o[K].group.classList.toggle("gone", !C || j);
      let Ye = (be, He) => u(b, te(k, te(ne(Re, be * T), ne(Fe, He * T)))), wn = [Ye(0.3, 0.3), Ye(0.5, 0.3), Ye(0.5, 0.5), Ye(0.3, 0.5)];
      if (d(o[K].hit, wn, !0), d(o[K].seen, wn, !0), !C) {
        let be = Array.from({ length: Wn + 1 }, (He, je) => {
          let ie = 2 * Math.PI * je / Wn;
          return u(b, te(k, te(ne(Re, Math.cos(ie) * T), ne(Fe, Math.sin(ie) * T))));
        });
        d(r[K].hit, be), d(r[K].seen, be);
      }
    }), f(c.hit, w, 13), f(c.seen, w, 7);
    let A = z && u(b, z);
    d(l, [w, A]), f(s.hit, A, 16), s.seen.setAttribute("d", A ? `M${A[0] - 8} ${A[1]}h16M${A[0]} ${A[1] - 8}v16M${A[0] - 5} ${A[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let B = t.effect(() => {
    let m = t.target.value, b = t.view.value;
    e.classList.toggle("empty", !m || !b), m && b && V(m, b);
  }), vn = (m, b, k) => mo(m.hole, (b.clientX - k.left - m.fit.x) / m.fit.scale, (b.clientY - k.top - m.fit.y) / m.fit.scale);
  function qe(m, b, k) {
    m.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let T = t.view.peek();
      if (!T || !t.target.peek()) return;
      let C = e.getBoundingClientRect(), z = k(T), A = t.hold(b), O = vn(T, w, C);
      z(O, !1, { ...A, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), m.setPointerCapture(w.pointerId), m.classList.add("held");
      let K = (j) => {
        p.textContent = z(vn(T, j, C), j.ctrlKey || j.metaKey, A), p.setAttribute("x", String(j.clientX - C.left + 16)), p.setAttribute("y", String(j.clientY - C.top - 12));
      }, I = (j) => {
        m.removeEventListener("pointermove", K), m.removeEventListener("pointerup", Qe), m.removeEventListener("pointercancel", Re), removeEventListener("keydown", Fe, !0), m.classList.remove("held"), p.textContent = "", j ? A.end() : A.cancel();
      }, Qe = () => I(!0), Re = () => I(!1), Fe = (j) => {
        j.key === "Escape" && (j.stopPropagation(), I(!1));
      };
      m.addEventListener("pointermove", K), m.addEventListener("pointerup", Qe), m.addEventListener("pointercancel", Re), addEventListener("keydown", Fe, !0);
    });
  }
  let $t = (m, b, k) => k ? Math.round(m / b) * b : m, Lt = (m) => m.map((b) => b.toFixed(2)).join("  ") + " m";
  ge.forEach((m, b) => {
    qe(i[b].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (T, C, z) => {
        let A = ko(k, m, T);
        w ??= A;
        let O = ne(m, $t(A - w, On, C));
        return z.move(O), Lt(O);
      };
    }), qe(o[b].group, "move", () => yn(m)), qe(r[b].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (T, C, z) => {
        let A = Gn(k.position, m, T), O = A && qt(Me(A, k.position), ho(m));
        if (!O) return "";
        w.at ??= O;
        let K = Math.atan2(ce(m, bo(w.at, O)), ce(w.at, O)), I = $t(K, yo, C);
        return z.rotate(m, I), `${(I * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), qe(c.group, "move", (m) => yn(m.hole.forward)), qe(s.group, "aim", (m) => {
    let b = t.target.peek(), k = b.aim ?? te(b.position, ne(b.direction, 3 * g(m, b.position))), w = kn(k, m.hole.forward);
    return (T, C, z) => {
      let A = w(T, C), O = te(k, A);
      return go(O, b.position) > 1e-3 && z.turn(qt(Me(O, b.position)), O), Lt(O);
    };
  });
  function yn(m) {
    let b = kn(t.target.peek().position, m);
    return (k, w, T) => {
      let C = b(k, w);
      return T.move(C), Lt(C);
    };
  }
  function kn(m, b) {
    let k = null;
    return (w, T) => {
      let C = Gn(m, b, w);
      return C ? (k ??= C, Me(C, k).map((z) => $t(z, On, T))) : [0, 0, 0];
    };
  }
  return { stop: B };
}
function ko(e, t, n) {
  let a = Me(e, n.origin), l = ce(t, n.direction), r = 1 - l * l;
  return r < 1e-6 ? 0 : (l * ce(n.direction, a) - ce(t, a)) / r;
}
function Gn(e, t, n) {
  let a = ce(t, n.direction);
  if (Math.abs(a) < 1e-4 * fo(t)) return null;
  let l = ce(Me(e, n.origin), t) / a;
  return l < 0 || l > 1e6 ? null : te(n.origin, ne(n.direction, l));
}

// src/later/handles.tsx
import { jsx as Qo } from "./desk.js";
function Bo([e, t, n, a], [l, r, o, i]) {
  return [
    a * l + e * i + t * o - n * r,
    a * r - e * o + t * i + n * l,
    a * o + e * r - t * l + n * i,
    a * i - e * l - t * r - n * o
  ];
}
var Ko = () => !Lo.value && qo.value !== "watch" && xo.value.you && Do.value !== "aim", zn = Ft(() => {
  let e = Ro.value;
  if (!e || !Ko()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => at.get(a) && !at.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = wo.value.filter((n) => _n(nt.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), Xn = (e) => {
  let t = at.get(e);
  return t?.place?.position ?? (t?.box ? Po(t.box) : null);
}, Uo = Ft(() => {
  let e = zn.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? _n(nt.get(t)) : Xn(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? nt.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: $o.value
  };
}), _o = Ft(() => {
  let e = Fo.value;
  if (Go.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: Vo(e.camera, t, n), fit: Co(t, n) };
}), zo = {
  effect: Mo,
  target: Uo,
  view: _o,
  hold(e) {
    let t = zn.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", l = a === "lamps" ? No(n) : n.length === 1 ? To("thing", n[0]) : `${n.length} things`, r = new So(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${l}`), o = a === "lamps" ? Io(n) : new Map(n.map((s) => [s, Xn(s)])), i = new Map(n.map((s) => [s, (a === "lamps" ? nt : at).get(s)?.place])), c = (s) => {
      let p = n.map((u) => [u, s(u)]).filter(([, u]) => u);
      r.set({ [a]: Object.fromEntries(p.map(([u, g]) => [u, { place: g }])) });
    };
    return {
      move: (s) => a === "lamps" ? r.set(Ao(n, s, o)) : c((p) => ({ position: Kn(o.get(p), s) })),
      turn: (s, p) => c((u) => i.get(u)?.direction ? { direction: s, ...p ? { aim: p } : {} } : null),
      rotate: (s, p) => c((u) => {
        let g = i.get(u);
        if (g?.direction) {
          let v = Eo(Un(g.direction, s, p)), V = g.aim && g.position ? Un(Ho(g.aim, g.position), s, p) : null;
          return { direction: v, ...V ? { aim: Kn(g.position, V) } : {} };
        }
        let d = Math.sin(p / 2), f = [s[0] * d, s[1] * d, s[2] * d, Math.cos(p / 2)];
        return { rotation: Bo(f, g?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => r.end(),
      cancel: () => r.cancel()
    };
  }
};
function Xo() {
  let e = Wo(null);
  return Oo(() => Bn(e.current, zo).stop, []), Qo("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as Da, deselect as ti, Icon as tn, selection as ni, signal as ai } from "./desk.js";

// src/later/measure.tsx
import {
  deselect as jn,
  digits as $e,
  edit as ot,
  grids as tr,
  Icon as Zn,
  length as Le,
  luxText as Pe,
  maintenance as Ht,
  meters as nr,
  selection as Jn,
  spacing as ar
} from "./desk.js";

// src/later/parts.tsx
import { Field as Qn, Gesture as Yo, Range as jo, stroke as Zo, useRef as Jo } from "./desk.js";
import { jsx as ae, jsxs as lt } from "./desk.js";
function q({ title: e, note: t, children: n }) {
  return lt("section", { class: "part", "aria-label": e, children: [
    lt("h3", { children: [
      e,
      t && ae("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function W(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function R(e) {
  return lt("label", { class: "line", children: [
    ae("span", { children: e.label }),
    ae(Qn, { ...e, label: e.name ?? e.label })
  ] });
}
function er(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function J({ label: e, names: t, quantity: n, value: a, set: l, step: r, disabled: o }) {
  let i = t ?? ["X", "Y", "Z"];
  return lt("div", { class: "line", role: "group", "aria-label": e, children: [
    ae("span", { children: e }),
    ae("span", { class: "triple", children: i.map((c, s) => ae(
      Qn,
      {
        label: `${e} ${c}`,
        quantity: n,
        value: a[s],
        text: er(a[s], n),
        step: r,
        disabled: o,
        set: (p) => l(s, p)
      },
      c
    )) })
  ] });
}
function Ce({ label: e, name: t, value: n, text: a, patch: l, reset: r, notch: o, class: i, style: c, disabled: s }) {
  let p = Jo(null), u = (d) => () => {
    p.current?.[d](), p.current = null;
  }, g = (d) => p.current ? p.current.set(l(d)) : Zo(e + t, t, l(d));
  return ae(
    jo,
    {
      label: e,
      value: n,
      text: a,
      notch: o,
      class: i,
      gradient: c,
      disabled: s,
      begin: () => p.current = new Yo(t),
      on: g,
      end: u("end"),
      cancel: u("cancel"),
      reset: r === void 0 ? void 0 : () => g(r)
    }
  );
}
function Se({ value: e, label: t, set: n }) {
  return ae("span", { class: "field name-field", children: ae(
    "input",
    {
      type: "text",
      "aria-label": t,
      value: e,
      maxLength: 120,
      spellcheck: !1,
      onChange: (a) => {
        let l = a.currentTarget.value.trim();
        l && l !== e ? n(l) : a.currentTarget.value = e;
      },
      onKeyDown: (a) => {
        a.key === "Enter" && a.currentTarget.blur(), a.key === "Escape" && (a.stopPropagation(), a.currentTarget.value = e, a.currentTarget.blur());
      }
    }
  ) });
}
var le = (e, t, n) => e.map((a, l) => l === t ? n(a) : a);

// src/later/measure.tsx
import { Fragment as Nt, jsx as L, jsxs as U } from "./desk.js";
var lr = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function ea() {
  let e = Jn.value?.ids[0], t = nr.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, l) => {
    let { lux: r, ...o } = { ...t, ...l };
    ot(`${t.name}: ${a}`, { meters: { [e]: o } });
  };
  return U(Nt, { children: [
    L("header", { class: "panel-head", children: L(Se, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    L("p", { class: "crumbs", children: t.lux ? `${Pe(t.lux[0] * Ht.value)} ±${Pe(t.lux[1] * Ht.value, !1)}` : "measuring" }),
    L("div", { class: "scroll", children: U(q, { title: "Meter", children: [
      U("label", { class: "line", children: [
        L("span", { children: "Measures" }),
        L("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: lr.map(([a, l]) => L("option", { value: a, children: l }, a)) })
      ] }),
      L(J, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, l) => n("move", { point: le(t.point, a, l) }) }),
      L(J, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, l) => n("turn", { normal: le(t.normal, a, l) }) }),
      U("button", { class: "plain full", onClick: () => {
        jn(), ot(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        L(Zn, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var Yn = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function ta() {
  let e = Jn.value?.ids[0], t = tr.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This grid is gone." });
  let n = Ht.value, a = (i, c) => {
    let { name: s, corner: p, u, v: g, normal: d, columns: f, rows: v, target: V } = { ...t, ...c };
    ot(`${t.name}: ${i}`, { grids: { [e]: { name: s, corner: p, u, v: g, normal: d, columns: f, rows: v, target: V } } });
  }, l = () => {
    let i = ar(Math.max(Le(t.u), Le(t.v)));
    a("standard spacing", { columns: Math.max(1, Math.ceil(Le(t.u) / i)), rows: Math.max(1, Math.ceil(Le(t.v) / i)) });
  }, r = (i, c, s) => U(Nt, { children: [
    L("dt", { children: i }),
    L("dd", { children: c == null ? "…" : s(c) })
  ] }), o = t.target ?? { lux: 500, uniformity: 0.6 };
  return U(Nt, { children: [
    L("header", { class: "panel-head", children: L(Se, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    U("p", { class: "crumbs", children: [
      $e(Le(t.u), 2),
      " × ",
      $e(Le(t.v), 2),
      " m, ",
      $e(t.columns * t.rows),
      " points"
    ] }),
    U("div", { class: "scroll", children: [
      L(q, { title: "Figures", note: n === 1 ? "new" : `× ${$e(n, 2)}`, children: U("dl", { class: "figures", children: [
        r("Ē", t.mean, (i) => Pe(i * n)),
        r("E min", t.min, (i) => Pe(i * n)),
        r("E max", t.max, (i) => Pe(i * n)),
        r("U₀ = min / mean", t.uniformity, (i) => $e(i, 2)),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => $e(i, 2)),
        r("± of Ē", t.error, (i) => Pe(i * n))
      ] }) }),
      U(q, { title: "Target", children: [
        U("label", { class: "line", children: [
          L("span", { children: "Class" }),
          U("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let c = Yn[Number(i.currentTarget.value)];
            a("target", { target: c ? { lux: c[1], uniformity: c[2] } : null });
          }, children: [
            L("option", { value: "", children: t.target ? "choose…" : "none" }),
            Yn.map(([i, c, s], p) => U("option", { value: p, children: [
              i,
              ": ",
              c,
              " lx, U₀ ",
              s
            ] }, i)),
            L("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        L(R, { label: "Ē at least", quantity: "lux", step: 50, value: o.lux, set: (i) => a("target", { target: { ...o, lux: i(o.lux) } }) }),
        L(R, { label: "U₀ at least", quantity: "share", step: 0.05, value: o.uniformity, set: (i) => a("target", { target: { ...o, uniformity: i(o.uniformity) } }) })
      ] }),
      U(q, { title: "Area", children: [
        L(J, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, c) => a("move", { corner: le(t.corner, i, c) }) }),
        L(R, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        L(R, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        L("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: l, children: "Spacing of the standard" }),
        U("button", { class: "plain full", onClick: () => {
          jn(), ot(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          L(Zn, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as ve,
  chosenLamps as vr,
  copyAlong as yr,
  dot as Bt,
  edit as st,
  format as da,
  groups as ut,
  handles as rt,
  Icon as Ee,
  lamps as zt,
  layers as kr,
  normal as ma,
  output as ha,
  percent as _t,
  placed as wr,
  positionOf as ra,
  positions as xr,
  selection as Kt,
  signal as ba,
  spot as Mr,
  sub as ia,
  titleOf as Xt,
  tool as Cr,
  toLevel as sa,
  toTravel as Sr,
  typeLevel as Ut,
  up as $r,
  Fade as Lr,
  Field as Pr,
  wantLevel as ua,
  compass as ga,
  add as ct,
  scale as Ve,
  length as Tr,
  Range as Er,
  strokeLevel as ca,
  useRef as Vr
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as sr,
  digits as aa,
  edit as ur,
  fromHex as cr,
  hex as pr,
  lamps as la,
  mired as fe,
  titleOf as dr
} from "./desk.js";

// src/later/white.ts
import { css as or, mired as Dt } from "./desk.js";
function rr(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((r) => Math.max(0, r));
}
function ir(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function na(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (l, r) => {
    let o = Dt(e) + (Dt(t) - Dt(e)) * r / (n - 1);
    return or(rr(...ir(1e6 / o)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as Wt, jsx as H, jsxs as pe } from "./desk.js";
var We = 1800, Gt = 1e4, mr = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], hr = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], br = na(We, Gt), Ot = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(la.get(n).color) }]))
}), gr = (e) => {
  let t = 1e6 / (fe(We) + (fe(Gt) - fe(We)) * e);
  return Math.round(t / 10) * 10;
}, fr = (e) => (fe(e) - fe(We)) / (fe(Gt) - fe(We));
function oa() {
  let e = sr.value, t = e.map((o) => la.get(o)?.color).filter((o) => o !== void 0);
  if (!t.length) return null;
  let n = W(t.map((o) => o.mode)), a = t[0], l = dr(e), r = (o, i) => ur(`${l}: ${o}`, Ot(e, i));
  return pe(Wt, { children: [
    pe("div", { class: "line", children: [
      H("span", { children: "Colour" }),
      H("div", { class: "segments", role: "group", "aria-label": "Colour by", children: hr.map(([o, i]) => H("button", { "aria-pressed": n === o, onClick: () => r(`colour by ${i}`, () => ({ mode: o })), children: i }, o)) })
    ] }),
    n === "kelvin" && pe(Wt, { children: [
      pe("div", { class: "line slide", children: [
        H("span", { children: "White" }),
        H(
          Ce,
          {
            label: "Colour temperature",
            name: `${l}: white`,
            class: "mired",
            style: br,
            value: fr(a.kelvin),
            text: `${aa(a.kelvin)} kelvin`,
            patch: (o) => Ot(e, () => ({ mode: "kelvin", kelvin: gr(o) }))
          }
        )
      ] }),
      H(
        R,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: W(t.map((o) => o.kelvin)),
          step: 50,
          set: (o) => r("white", (i) => ({ mode: "kelvin", kelvin: o(i.kelvin) }))
        }
      ),
      H("div", { class: "whites", role: "group", "aria-label": "Whites", children: mr.map(([o, i]) => H("button", { title: i, "aria-label": `${o} kelvin, ${i}`, onClick: () => r(`${o} K`, () => ({ mode: "kelvin", kelvin: o })), children: o }, o)) }),
      pe("div", { class: "line slide", children: [
        H("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        H(
          Ce,
          {
            label: "Tint, magenta to green",
            name: `${l}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${aa(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (o) => Ot(e, () => ({ tint: Math.round((o * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      H(R, { label: "", name: "Tint, typed", quantity: "number", value: W(t.map((o) => o.tint)), step: 1, set: (o) => r("tint", (i) => ({ tint: Math.max(-50, Math.min(50, o(i.tint))) })) })
    ] }),
    n === "rgb" && pe(Wt, { children: [
      pe("label", { class: "line", children: [
        H("span", { children: "Colour" }),
        H("input", { type: "color", class: "pick", "aria-label": "Colour", value: pr(a.rgb), onChange: (o) => r("colour", () => ({ mode: "rgb", rgb: cr(o.currentTarget.value) })) })
      ] }),
      H(
        J,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (o, i) => r("colour", (c) => ({ rgb: c.rgb.map((s, p) => p === o ? Math.max(0, i(s)) : s) }))
        }
      )
    ] }),
    n === "xy" && pe("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      H("span", { children: "x, y" }),
      H("span", { class: "triple", children: [0, 1].map((o) => H(
        R,
        {
          label: "xy"[o],
          quantity: "number",
          step: 1e-3,
          value: W(t.map((i) => i.xy[o])),
          set: (i) => r("chromaticity", (c) => ({ xy: c.xy.map((s, p) => p === o ? Math.max(0.01, Math.min(0.9, i(s))) : s) }))
        },
        o
      )) })
    ] }),
    n === null && H("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as Qt, jsx as y, jsxs as N } from "./desk.js";
var Te = ba(1), it = ba([1, 0, 0]), Ar = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], pt = 180 / Math.PI;
function pa(e, t) {
  let { right: n, ahead: a } = ga(t), l = -Bt(e, t);
  return [Math.atan2(Bt(e, n), Bt(e, a)) * pt, Math.asin(Math.max(-1, Math.min(1, l))) * pt];
}
function Ir(e, t, n) {
  let { right: a, ahead: l } = ga(n), [r, o] = [e / pt, t / pt], i = ct(Ve(a, Math.sin(r)), Ve(l, Math.cos(r)));
  return ma(ct(Ve(i, Math.cos(o)), Ve(n, -Math.sin(o))));
}
function qr({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction);
  return N("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    N("button", { "aria-pressed": Cr.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => ve("aim"), children: [
      y(Ee, { name: "aim" }),
      "Aim"
    ] }),
    y("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => ve("solo"), children: y(Ee, { name: "solo" }) }),
    y("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => ve("from-lamp"), children: y(Ee, { name: "eye" }) }),
    y("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => ve("frame"), children: y(Ee, { name: "frame" }) }),
    y("span", { class: "gap" }),
    y("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => ve("park"), children: "Park" }),
    y("button", { class: "icon", "aria-label": `Remove ${Xt(e)}`, title: "Remove (Del)", onClick: () => ve("remove"), children: y(Ee, { name: "bin" }) })
  ] });
}
function Rr({ ids: e, all: t }) {
  let n = W(t.map((o) => o.level)), a = t.reduce((o, i) => o + i.flux * ha(i), 0), l = t.every((o) => o.free), r = e[e.length - 1];
  return N(q, { title: "Light", note: l ? "re-mix" : "re-trace", children: [
    N("div", { class: "line slide", children: [
      y("span", { children: "Level" }),
      y(Fr, { id: r })
    ] }),
    N("label", { class: "line", children: [
      y("span", {}),
      y(
        Pr,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: W(t.map((o) => o.flux)) ?? void 0,
          step: 0.01,
          set: (o) => Ut(e, o),
          open: ua.value,
          opened: () => ua.value = "",
          id: "level"
        }
      )
    ] }),
    y(
      R,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (o) => Ut(e, (i, c) => o(i * c) / c)
      }
    ),
    N("div", { class: "line", children: [
      y("span", { children: "Stops" }),
      y("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: Ar.map(([o, i]) => y("button", { "aria-label": `${i} stop`, onClick: () => Ut(e, (c) => Math.min(1e3, c * 2 ** o)), children: i }, i)) })
    ] }),
    N("p", { class: "sum", children: [
      da(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (ut.get(t[0].group)?.level ?? 1) !== 1 && ` (${_t(t[0].level)} % × ${_t(ut.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    y(oa, {})
  ] });
}
function Fr({ id: e }) {
  let t = Vr(null), n = zt.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, l = (r) => () => {
    t.current?.[r](), t.current = null;
  };
  return y(
    Er,
    {
      label: "Level",
      value: Sr(n.level),
      text: `${_t(n.level)} %, ${da(n.flux * ha(n), "flux")}`,
      begin: () => t.current = new Lr(a),
      on: (r) => t.current ? t.current.to(sa(r)) : ca(a, sa(r)),
      end: l("end"),
      cancel: l("cancel"),
      reset: () => ca(a, 1)
    }
  );
}
function Ge(e, t, n) {
  let a = {};
  for (let l of e) {
    let r = zt.get(l), o = n(r.place ?? {}, r);
    o && (a[l] = { place: o });
  }
  Object.keys(a).length && st(`${Xt(e)}: ${t}`, { lamps: a });
}
function Hr({ ids: e, all: t }) {
  let n = (l) => W(t.map((r) => r.place?.[l] ?? null)), a = (l) => t.some((r) => r.place?.[l] != null);
  return !a("outer") && !a("radius") ? null : N(q, { title: "Beam", note: "re-trace", children: [
    a("outer") && N(Qt, { children: [
      y(R, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (l) => Ge(e, "beam", (r) => r.outer == null ? null : { inner: Math.max(0.1, Math.min(r.outer, l(r.inner ?? r.outer))) }) }),
      y(R, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (l) => Ge(e, "beam", (r) => {
        if (r.outer == null) return null;
        let o = Math.max(0.2, Math.min(179, l(r.outer)));
        return { outer: o, inner: Math.min(r.inner ?? o, o) };
      }) })
    ] }),
    a("radius") && y(R, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (l) => Ge(e, "radius", (r) => r.radius == null ? null : { radius: Math.max(1e-3, l(r.radius)) }) })
  ] });
}
function Nr({ ids: e, all: t }) {
  let n = t.filter((u) => ra(u) !== null);
  if (!n.length) return null;
  let a = n.map((u) => ra(u)), l = (u, g) => W(g.map((d) => Math.round(d[u] * 1e4) / 1e4)), r = t.filter((u) => u.place?.direction), o = $r.value, i = r.map((u) => pa(u.place?.direction, o).map((g) => Math.round(g * 10) / 10)), c = t.map((u) => u.place?.aim).filter((u) => !!u), s = (u, g) => {
    let d = xr(e), f = {};
    for (let [v, V] of d) {
      let B = [0, 0, 0];
      B[u] = g(V[u]) - V[u], Object.assign(f, wr([v], B, d).lamps);
    }
    st(`Move ${Xt(e)}`, { lamps: f });
  }, p = (u, g) => Ge(e, u ? "tilt" : "pan", (d) => {
    if (!d.direction) return null;
    let f = pa(d.direction, o);
    f[u] = g(f[u]);
    let v = Ir(f[0], Math.max(-90, Math.min(90, f[1])), o), V = d.aim && d.position ? Tr(ia(d.aim, d.position)) : 0;
    return { direction: v, ...V && d.position ? { aim: ct(d.position, Ve(v, V)) } : {} };
  });
  return N(q, { title: "Place", note: "re-trace", children: [
    y(J, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((u) => l(u, a)), set: s }),
    r.length > 0 && N(Qt, { children: [
      y(R, { label: "Pan", quantity: "angle", step: 1, value: W(i.map((u) => u[0])), set: (u) => p(0, u) }),
      y(R, { label: "Tilt", quantity: "angle", step: 1, value: W(i.map((u) => u[1])), set: (u) => p(1, u) }),
      y(
        J,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: c.length ? [0, 1, 2].map((u) => l(u, c)) : [NaN, NaN, NaN],
          set: (u, g) => Ge(e, "aim", (d) => {
            if (!d.direction || !d.position) return null;
            let f = le(d.aim ?? ct(d.position, Ve(d.direction, 2)), u, g);
            return { aim: f, direction: ma(ia(f, d.position)) };
          })
        }
      )
    ] }),
    N("div", { class: "line", children: [
      y("span", { children: "Handles" }),
      N("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        y("button", { "aria-pressed": rt.value === "move", onClick: () => rt.value = "move", children: "Move" }),
        y("button", { "aria-pressed": rt.value === "turn", onClick: () => rt.value = "turn", children: "Turn" })
      ] })
    ] }),
    r.length > 0 && Mr.value && y("button", { class: "plain full", onClick: () => ve("aim-here"), children: "Aim at the last point" })
  ] });
}
function Dr({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : N(q, { title: "Copies along a line", children: [
    y(R, { label: "How many", quantity: "number", step: 1, value: Te.value, set: (n) => Te.value = Math.max(1, Math.min(100, Math.round(n(Te.value)))) }),
    y(J, { label: "Step", quantity: "length", step: 0.05, value: it.value, set: (n, a) => it.value = le(it.value, n, a) }),
    N("button", { class: "plain full", onClick: () => yr(e, Te.value, it.value), children: [
      y(Ee, { name: "copy" }),
      Te.value === 1 ? "One copy" : `${Te.value} copies`
    ] })
  ] });
}
function fa() {
  let e = vr.value, t = e.map((o) => zt.get(o)).filter((o) => !!o);
  if (!t.length) return y("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && ut.get(n.group), l = Kt.value?.kind === "group" ? ut.get(Kt.value.ids[0]) : void 0, r = n?.layer != null ? kr.value[n.layer] : void 0;
  return N(Qt, { children: [
    y("header", { class: "panel-head", children: n ? y(Se, { label: "Name of the lamp", value: n.name, set: (o) => st(`Rename ${n.name}`, { lamps: { [e[0]]: { name: o } } }) }) : l ? y(Se, { label: "Name of the group", value: l.name, set: (o) => st(`Rename ${l.name}`, { groups: { [Kt.value.ids[0]]: { name: o } } }) }) : N("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    y("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((o) => o.on).length} of ${t.length} on` }),
    N("div", { class: "scroll", children: [
      y(qr, { ids: e, all: t }),
      y(Rr, { ids: e, all: t }),
      y(q, { title: "Photometry", children: y("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      y(Hr, { ids: e, all: t }),
      y(Nr, { ids: e, all: t }),
      y(Dr, { ids: e, all: t }),
      y("p", { class: "cost", children: t.every((o) => o.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as Yt,
  candles as dt,
  command as Or,
  digits as ht,
  edit as va,
  Field as Wr,
  filterOf as xa,
  go as Gr,
  history as Br,
  hovered as ya,
  Icon as bt,
  layers as Kr,
  lookOnly as ka,
  maintenance as Ae,
  materials as Ur,
  percent as _r,
  scene as zr,
  select as Ma,
  signal as Xr,
  singleKeys as wa,
  sub as Qr,
  things as Yr,
  travel as mt,
  Virtual as Ca
} from "./desk.js";
import { Fragment as jr, jsx as x, jsxs as E } from "./desk.js";
function Sa() {
  let e = zr.value;
  if (!e) return null;
  let t = Qr(e.bounds[1], e.bounds[0]);
  return E(jr, { children: [
    E(q, { title: "Room", children: [
      E("p", { children: [
        t.map((n) => ht(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${ht(e.triangles)} triangles` : ""
      ] }),
      x("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && x("ul", { class: "buttons", children: e.cameras.map((n, a) => x("li", { children: x("button", { onClick: () => Gr(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && E("details", { children: [
        E("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        x("ul", { class: "remarks", children: e.warnings.map((n) => x("li", { children: n }, n)) })
      ] })
    ] }),
    E(q, { title: "Figures", children: [
      E("label", { class: "line", children: [
        x("span", { children: "Maintenance" }),
        x(Wr, { label: "Maintenance factor", quantity: "share", value: Ae.value, step: 0.05, set: (n) => Ae.value = Math.max(0.1, Math.min(1, n(Ae.value))) })
      ] }),
      E("p", { class: "quiet", children: [
        Ae.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Ae.value === 1 && x("button", { class: "plain", onClick: () => Ae.value = 0.8, children: "0.80" })
      ] }),
      E("div", { class: "line", children: [
        x("span", { children: "Unit" }),
        E("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          x("button", { "aria-pressed": dt.value === "lx", onClick: () => dt.value = "lx", children: "lx, cd/m²" }),
          x("button", { "aria-pressed": dt.value === "fc", onClick: () => dt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    x(q, { title: "Layers of light", children: x("ul", { class: "layers", children: Kr.value.map((n, a) => E("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      x("i", { class: "dot", "aria-hidden": "true" }),
      x("span", { children: n.name || `layer ${a + 1}` }),
      x("small", { children: n.held ? "held" : _r(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    E(q, { title: "Hands", children: [
      E("div", { class: "line", children: [
        x("span", { children: "Faders" }),
        E("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          x("button", { "aria-pressed": mt.value === "square", onClick: () => mt.value = "square", children: "Square law" }),
          x("button", { "aria-pressed": mt.value === "linear", onClick: () => mt.value = "linear", children: "Even" })
        ] })
      ] }),
      E("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: wa.value, onChange: (n) => wa.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      E("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: ka.value, onChange: (n) => ka.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var gt = Xr("");
function $a({ label: e }) {
  return x("span", { class: "field filter", children: x("input", { type: "text", "aria-label": e, placeholder: "Filter", value: gt.value, onInput: (t) => gt.value = t.currentTarget.value }) });
}
function La() {
  let e = xa(Yr, gt.value);
  return E("div", { class: "listing", children: [
    x($a, { label: "Filter things" }),
    x(
      Ca,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => ya.value = { kind: "thing", id: n }, onPointerLeave: () => ya.value = null, children: [
            x("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => va(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: x(bt, { name: a.hidden ? "eye-off" : "eye" }) }),
            x("button", { class: "row-name", onClick: () => Ma("thing", n), children: x("span", { children: a.name }) }),
            x("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => va(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: x(bt, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function Pa() {
  let e = xa(Ur, gt.value);
  return E("div", { class: "listing", children: [
    x($a, { label: "Filter materials" }),
    x(
      Ca,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row material", role: "listitem", children: [
            x("button", { class: "row-name", onClick: () => Ma("material", n), children: x("span", { children: a.name }) }),
            E("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${ht(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function Ta() {
  let e = Br.value;
  return E(q, { title: "History", children: [
    E("p", { children: [
      e.steps === 1 ? "One step" : `${ht(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => Yt("undo"), children: [
      x(bt, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => Yt("redo"), children: [
      x(bt, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    x("button", { class: "plain full", onClick: () => Yt("save"), children: "Save a version with a name…" }),
    x("button", { class: "plain full", onClick: () => Or({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as jt,
  edit as Ia,
  fromHex as Zr,
  hex as Jr,
  Icon as Ea,
  materials as qa,
  middle as Va,
  select as Ra,
  selection as Fa,
  things as Zt
} from "./desk.js";
import { Fragment as en, jsx as S, jsxs as X } from "./desk.js";
var Jt = 180 / Math.PI;
function Aa(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * Jt : 0;
}
function ei(e, t) {
  let n = [0, 0, 0, Math.cos(t / Jt / 2)];
  return n[e] = Math.sin(t / Jt / 2), n;
}
function Ha() {
  let e = (Fa.value?.ids ?? []).filter((c) => Zt.get(c)), t = e.map((c) => Zt.get(c));
  if (!t.length) return S("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, l = t.some((c) => c.locked), r = (c, s) => Ia(`${a}: ${c}`, { things: Object.fromEntries(e.map((p, u) => [p, s(t[u])])) }), o = t.map((c) => c.place?.position ?? (c.box ? Va(c.box) : [0, 0, 0])), i = n.box ? [0, 1, 2].map((c) => n.box[1][c] - n.box[0][c]) : null;
  return X(en, { children: [
    S("header", { class: "panel-head", children: S("h2", { children: a }) }),
    i && X("p", { class: "crumbs", children: [
      i.map((c) => jt(c, 2)).join(" × "),
      " m"
    ] }),
    X("div", { class: "scroll", children: [
      X("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        X("button", { "aria-pressed": t.every((c) => c.hidden), onClick: () => r(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          S(Ea, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        X("button", { "aria-pressed": l, onClick: () => r(l ? "unlock" : "lock", () => ({ locked: !l })), children: [
          S(Ea, { name: l ? "lock" : "unlock" }),
          l ? "Locked" : "Lock"
        ] })
      ] }),
      X(q, { title: "Place", note: "re-trace", children: [
        l && S("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        S(
          J,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: l,
            value: [0, 1, 2].map((c) => W(o.map((s) => Math.round(s[c] * 1e4) / 1e4))),
            set: (c, s) => r("move", (p) => ({ place: { position: le(p.place?.position ?? Va(p.box), c, s) } }))
          }
        ),
        [0, 1, 2].map((c) => S(
          R,
          {
            label: `Turn ${"XYZ"[c]}`,
            quantity: "angle",
            step: 5,
            disabled: l,
            value: W(t.map((s) => Math.round(Aa(s.place?.rotation, c) * 10) / 10)),
            set: (s) => r("turn", (p) => ({ place: { rotation: ei(c, s(Aa(p.place?.rotation, c))) } }))
          },
          c
        )),
        S(
          R,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: l,
            value: W(t.map((c) => c.place?.scale ?? 1)),
            set: (c) => r("scale", (s) => ({ place: { scale: Math.max(1e-3, c(s.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      S(q, { title: "Materials", children: S("ul", { class: "buttons", children: n.materials.map((c) => S("li", { children: S("button", { onClick: () => Ra("material", c), children: qa.get(c)?.name ?? `material ${c}` }) }, c)) }) })
    ] })
  ] });
}
function Na() {
  let e = Fa.value?.ids[0], t = qa.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This material is gone." });
  let n = (s, p) => Ia(`${t.name}: ${s}`, { materials: { [e]: p } }), a = t.transmittance ? "transmittance" : "color", l = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], o = ((s) => 0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2])(l), i = (s) => l.map((p) => Math.max(0, Math.min(1, o > 1e-4 ? p / o * s : s))), c = (s, p) => t[p] != null && X(en, { children: [
    X("div", { class: "line slide", children: [
      S("span", { children: s }),
      S(Ce, { label: s, name: `${t.name}: ${s.toLowerCase()}`, value: t[p], text: jt(t[p], 2), patch: (u) => ({ materials: { [e]: { [p]: Math.round(u * 1e3) / 1e3 } } }) })
    ] }),
    S(R, { label: "", name: `${s}, typed`, quantity: "share", step: 0.01, value: t[p], set: (u) => n(s.toLowerCase(), { [p]: Math.max(0, Math.min(1, u(t[p]))) }) })
  ] });
  return X(en, { children: [
    S("header", { class: "panel-head", children: S("h2", { children: t.name }) }),
    S("p", { class: "crumbs", children: t.kind }),
    X("div", { class: "scroll", children: [
      X(q, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        X("div", { class: "line slide", children: [
          S("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          S(Ce, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: o, text: jt(o, 2), patch: (s) => ({ materials: { [e]: { [a]: i(Math.min(0.95, s)) } } }) })
        ] }),
        S(R, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(o * 1e3) / 1e3, set: (s) => n("reflectance", { [a]: i(Math.min(0.98, s(o))) }) }),
        X("label", { class: "line", children: [
          S("span", { children: "Colour" }),
          S("input", { type: "color", class: "pick", "aria-label": "Colour", value: Jr(l), onChange: (s) => n("colour", { [a]: Zr(s.currentTarget.value) }) })
        ] }),
        c("Roughness", "roughness"),
        c("Gloss", "specular")
      ] }),
      S(q, { title: "On", children: S("ul", { class: "buttons", children: Zt.all().filter(([, s]) => s.materials.includes(e)).slice(0, 40).map(([s, p]) => S("li", { children: S("button", { onClick: () => Ra("thing", s), children: p.name }) }, s)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as Oa, jsx as D, jsxs as nn } from "./desk.js";
var Be = ["Scene", "Things", "Materials", "History"], de = ai("Scene");
function li() {
  let e = { Scene: Sa, Things: La, Materials: Pa, History: Ta }[de.value];
  return nn(Oa, { children: [
    D("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), de.value = Be[(Be.indexOf(de.value) + a + Be.length) % Be.length], document.getElementById(`tab-${de.value}`)?.focus());
    }, children: Be.map((n) => D("button", { id: `tab-${n}`, role: "tab", "aria-selected": de.value === n, "aria-controls": "tab-panel", tabIndex: de.value === n ? 0 : -1, onClick: () => de.value = n, children: n }, n)) }),
    D("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${de.value}`, tabIndex: 0, children: D(e, {}) })
  ] });
}
function oi() {
  let e = ni.value;
  return e ? nn(Oa, { children: [
    nn("nav", { class: "chooser", "aria-label": "Selection", children: [
      D("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => Da("previous"), children: D(tn, { name: "back" }) }),
      D("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => Da("next"), children: D(tn, { name: "forth" }) }),
      D("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      D("span", { class: "gap" }),
      D("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: ti, children: D(tn, { name: "close" }) })
    ] }),
    (e.kind === "lamp" || e.kind === "group") && D(fa, {}),
    e.kind === "thing" && D(Ha, {}),
    e.kind === "material" && D(Na, {}),
    e.kind === "meter" && D(ea, {}),
    e.kind === "grid" && D(ta, {})
  ] }) : D(li, {});
}

// src/later/legend.tsx
import { candles as ri, display as ii, Field as si, show as ui, three as ci, useRef as pi } from "./desk.js";
import { jsx as Q, jsxs as ft } from "./desk.js";
var an = [1, 2, 5];
function di(e, t, n) {
  let a = [];
  if (n === "linear") {
    let l = (t - e) / 5, r = 10 ** Math.floor(Math.log10(l)), o = r * (an.find((i) => i * r >= l) ?? 10);
    for (let i = Math.ceil(e / o) * o; i <= t * 1.0001; i += o) a.push(i);
    return a;
  }
  for (let l = Math.floor(Math.log10(e)); l <= Math.ceil(Math.log10(t)); l++)
    for (let r of an) {
      let o = r * 10 ** l;
      o >= e * 0.999 && o <= t * 1.001 && a.push(o);
    }
  return a.length > 10 ? a.filter((l) => Math.abs(Math.log10(l) % 1) < 1e-6) : a;
}
function mi(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var oe = (e, t) => {
  let n = { ...e, ...t };
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && ui({ false_color: n });
};
function Wa(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return an[a] * 10 ** ((n - a) / 3);
}
function hi() {
  let e = ii.value.false_color, t = pi(null);
  if (!e) return null;
  let n = ri.value === "fc", a = e.quantity === "illuminance", l = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", r = n ? a ? 1 / 10.7639 : 0.2919 : 1, o = e.colors, i = o?.length ? `linear-gradient(to top, ${o.join(", ")})` : void 0, c = (p) => ({
    onPointerDown: (u) => {
      u.currentTarget.setPointerCapture(u.pointerId), t.current = { y: u.clientY, end: p, from: e[p] };
    },
    onPointerMove: (u) => {
      let g = t.current;
      g?.end === p && oe(e, { [p]: Wa(g.from, Math.round((g.y - u.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (u) => {
      let g = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[u.key];
      g && (u.preventDefault(), u.stopPropagation(), oe(e, { [p]: Wa(e[p], g) }));
    }
  }), s = ({ end: p }) => ft("div", { class: "end", children: [
    Q(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": p === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[p],
        "aria-valuemin": 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${ci(e[p] * r)} ${l}`,
        ...c(p)
      }
    ),
    Q(
      si,
      {
        label: p === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[p] * r).toPrecision(3)),
        set: (u) => oe(e, { [p]: u(e[p] * r) / r })
      }
    )
  ] });
  return ft("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    ft("header", { children: [
      Q(
        "button",
        {
          "aria-label": `${l}: ${a ? "illuminance" : "luminance"}, change`,
          onClick: () => oe(e, { quantity: a ? "luminance" : "illuminance" }),
          children: l
        }
      ),
      Q("button", { "aria-pressed": e.scale === "log", onClick: () => oe(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      Q("button", { "aria-pressed": e.lines, onClick: () => oe(e, { lines: !e.lines }), children: "lines" })
    ] }),
    Q(s, { end: "high" }),
    Q("div", { class: "scale", style: { background: i }, children: di(e.low, e.high, e.scale).map((p) => Q("span", { style: { bottom: `${100 * mi(p, e)}%` }, children: String(Number((p * r).toPrecision(2))) }, p)) }),
    Q(s, { end: "low" }),
    ft("footer", { children: [
      Q("button", { onClick: () => oe(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      Q("button", { onClick: () => oe(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      Q(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (p) => oe(e, { palette: p.currentTarget.value }),
          children: e.palettes?.map((p) => Q("option", { children: p }, p)) ?? Q("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as rn,
  act as Ya,
  ask as Ci,
  command as Si,
  copyText as $i,
  digits as Li,
  go as Pi,
  hear as Ti,
  lamps as Ei,
  say as un,
  select as Vi,
  send as yt,
  sheet as Ue,
  shown as Ai,
  signal as _e,
  useEffect as sn,
  useLayoutEffect as Ii,
  useRef as wt,
  walkNames as qi,
  whyNotTo as Ri
} from "./desk.js";

// src/later/csv.ts
import { add as Ga, grids as bi, maintenance as gi, meters as fi, scale as Ba, scene as Ka } from "./desk.js";
var vi = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function yi() {
  let e = gi.peek(), t = [["scene", Ka.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of fi.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of bi.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [l, r] of Object.entries(a)) t.push([l, r == null ? null : r * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((l, r) => {
      let [o, i] = [r % n.columns, Math.floor(r / n.columns)], c = Ga(n.corner, Ga(Ba(n.u, (o + 0.5) / n.columns), Ba(n.v, (i + 0.5) / n.rows)));
      t.push([...c.map((s) => s.toFixed(3)), l === null ? null : l * e]);
    });
  }
  return t.map((n) => n.map(vi).join(",")).join(`\r
`) + `\r
`;
}
function ln(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function Ua() {
  let e = URL.createObjectURL(new Blob([yi()], { type: "text/csv" }));
  ln(`${Ka.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var Xa = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], vt = new Uint8Array(512), on = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  vt[e] = vt[e + 255] = t, on[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var _a = (e, t) => e && t ? vt[on[e] + on[t]] : 0;
function ki(e, t) {
  let n = [1];
  for (let l = 0; l < t; l++) {
    let r = new Array(n.length + 1).fill(0);
    n.forEach((o, i) => {
      r[i] ^= o, r[i + 1] ^= _a(o, vt[l]);
    }), n = r;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let l = 0; l < e.length; l++) {
    let r = a[l];
    r && n.forEach((o, i) => a[l + i] ^= _a(o, r));
  }
  return a.slice(e.length);
}
function wi(e, t) {
  let [n, a, l] = Xa[t - 1], r = [], o = (g, d) => {
    for (let f = d - 1; f >= 0; f--) r.push(g >> f & 1);
  };
  for (o(4, 4), o(e.length, 8), e.forEach((g) => o(g, 8)), o(0, Math.min(4, n * 8 - r.length)); r.length % 8; ) r.push(0);
  let i = [];
  for (let g = 0; g < r.length; g += 8) i.push(parseInt(r.slice(g, g + 8).join(""), 2));
  for (let g = 236; i.length < n; g ^= 253) i.push(g);
  let c = n / l, s = Array.from({ length: l }, (g, d) => i.slice(d * c, (d + 1) * c)), p = s.map((g) => ki(g, a)), u = (g) => g[0].flatMap((d, f) => g.map((v) => v[f]));
  return [...u(s), ...u(p)];
}
var xi = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function Mi(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function za(e) {
  let t = e.length, n = 0, a = 0;
  for (let l of [!1, !0])
    for (let r = 0; r < t; r++) {
      let o = Array.from({ length: t }, (s, p) => l ? e[p][r] : e[r][p]), i = 1;
      for (let s = 1; s <= t; s++)
        s < t && o[s] === o[s - 1] ? i++ : (i >= 5 && (n += i - 2), i = 1);
      let c = o.map(Number).join("");
      for (let s = 0; s + 11 <= t; s++) {
        let p = c.slice(s, s + 11);
        (p === "10111010000" || p === "00001011101") && (n += 40);
      }
    }
  for (let l = 0; l < t; l++)
    for (let r = 0; r < t; r++)
      e[l][r] && a++, r && l && e[l][r] === e[l - 1][r] && e[l][r] === e[l][r - 1] && e[l][r] === e[l - 1][r - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function Qa(e) {
  let t = [...new TextEncoder().encode(e)], n = Xa.findIndex(([d]) => t.length + 2 <= d) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, l = Array.from({ length: a }, () => new Array(a).fill(!1)), r = Array.from({ length: a }, () => new Array(a).fill(!1)), o = (d, f, v) => {
    d < 0 || f < 0 || d >= a || f >= a || (l[f][d] = v, r[f][d] = !0);
  };
  for (let d = 0; d < a; d++)
    o(d, 6, d % 2 === 0), o(6, d, d % 2 === 0);
  for (let [d, f] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let v = -4; v <= 4; v++)
      for (let V = -4; V <= 4; V++) {
        let B = Math.max(Math.abs(V), Math.abs(v));
        o(d + V, f + v, B !== 2 && B !== 4);
      }
  if (n > 1) {
    let d = a - 7;
    for (let f = -2; f <= 2; f++) for (let v = -2; v <= 2; v++) o(d + v, d + f, Math.max(Math.abs(v), Math.abs(f)) !== 1);
  }
  let i = (d) => {
    let f = Mi(d);
    for (let v = 0; v < 15; v++) {
      let V = (f >> v & 1) === 1, B = v < 6 ? v : v < 8 ? v + 1 : a - 15 + v;
      o(8, B, V), o(v < 8 ? a - 1 - v : v < 9 ? 7 : 14 - v, 8, V);
    }
    o(8, a - 8, !0);
  };
  i(0);
  let c = wi(t, n), s = 0;
  for (let d = a - 1; d > 0; d -= 2) {
    d === 6 && (d = 5);
    for (let f = 0; f < a; f++)
      for (let v of [d, d - 1]) {
        let B = (d + 1 & 2) === 0 ? a - 1 - f : f;
        r[B][v] || (l[B][v] = s < c.length * 8 && (c[s >> 3] >> 7 - (s & 7) & 1) === 1, s++);
      }
  }
  let p = (d) => (i(d), l.map((f, v) => f.map((V, B) => V !== (!r[v][B] && xi[d](B, v))))), u = p(0), g = za(u);
  for (let d = 1; d < 8; d++) {
    let f = p(d), v = za(f);
    v < g && ([u, g] = [f, v]);
  }
  return u;
}

// src/later/sheets.tsx
import { Fragment as Ui, jsx as h, jsxs as $ } from "./desk.js";
function ze({ title: e, wide: t, children: n }) {
  let a = wt(null);
  Ii(() => {
    let r = a.current, o = document.activeElement;
    return r.open || r.showModal(), () => o?.focus();
  }, []);
  let l = () => Ue.value = null;
  return h(
    "dialog",
    {
      ref: a,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: l,
      onClick: (r) => r.target === a.current && l(),
      children: $("div", { class: "sheet-body", children: [
        $("header", { children: [
          h("h2", { children: e }),
          h("span", { class: "gap" }),
          h("button", { onClick: l, children: "Close" })
        ] }),
        n
      ] })
    }
  );
}
var Fi = [
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
function Hi() {
  let e = [...new Set(rn().map((t) => t.group))];
  return h(ze, { title: "All keys", wide: !0, children: $("div", { class: "help", children: [
    $("table", { children: [
      h("caption", { class: "spoken", children: "By hand" }),
      h("thead", { children: $("tr", { children: [
        h("th", { scope: "col", children: "What" }),
        h("th", { scope: "col", children: "Mouse" }),
        h("th", { scope: "col", children: "Keys, in the view" }),
        h("th", { scope: "col", children: "Fingers" })
      ] }) }),
      h("tbody", { children: Fi.map(([t, n, a, l]) => $("tr", { children: [
        h("th", { scope: "row", children: t }),
        h("td", { children: n }),
        h("td", { children: a.replace("walking keys", qi.value) }),
        h("td", { children: l })
      ] }, t)) })
    ] }),
    $("div", { class: "columns", children: [
      e.map((t) => $("section", { children: [
        h("h3", { children: t }),
        h("dl", { children: rn().filter((n) => n.group === t && n.keys).map((n) => $(Ui, { children: [
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
var kt = _e(""), Ke = _e(0);
function Ni() {
  let e = kt.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((l) => a.toLowerCase().includes(l)), n = rn().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: Ri(a.id), run: () => Ya(a.id) }));
  for (let { name: a, camera: l } of et())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => Pi(l, a) });
  if (e.length)
    for (let [a, l] of Ei.all()) {
      if (n.length > 60) break;
      t(l.name) && n.push({ label: l.name, note: "lamp", why: null, run: () => Vi("lamp", a) });
    }
  return n.slice(0, 60);
}
function Di() {
  let e = Ni(), t = Math.min(Ke.value, e.length - 1);
  sn(() => {
    kt.value = "", Ke.value = 0;
  }, []), sn(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (Ue.value = null, a.why ? un(a.why, "warn") : setTimeout(a.run, 0));
  };
  return $(ze, { title: "Command palette", children: [
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
        value: kt.value,
        onInput: (a) => {
          kt.value = a.currentTarget.value, Ke.value = 0;
        },
        onKeyDown: (a) => {
          let l = { ArrowDown: 1, ArrowUp: -1 }[a.key];
          l && (a.preventDefault(), Ke.value = (t + l + e.length) % Math.max(1, e.length)), a.key === "Enter" && (a.preventDefault(), n(e[t]));
        }
      }
    ),
    $("ul", { class: "commands", id: "commands", role: "listbox", "aria-label": "Commands", children: [
      e.map((a, l) => $(
        "li",
        {
          id: `command-${l}`,
          role: "option",
          "aria-selected": l === t,
          "aria-disabled": a.why !== null,
          title: a.why ?? void 0,
          onPointerMove: () => Ke.value = l,
          onClick: () => n(a),
          children: [
            h("span", { children: a.label }),
            h("kbd", { children: a.note })
          ]
        },
        a.label + l
      )),
      !e.length && h("li", { class: "quiet", role: "option", "aria-selected": "false", "aria-disabled": "true", children: "Nothing is called so." })
    ] })
  ] });
}
var ja = _e([]);
Ti("links", (e) => ja.value = e.links);
function Oi({ text: e }) {
  let t = Qa(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((l, r) => l.map((o, i) => o ? `M${i + 4} ${r + 4}h1v1h-1z` : "").join("")).join("");
  return $("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    h("rect", { width: n, height: n, fill: "#fff" }),
    h("path", { d: a, fill: "#000" })
  ] });
}
function Wi() {
  let e = _e(null), t = wt(e).current;
  return sn(() => {
    yt({ do: "links", what: "list" });
  }, []), $(ze, { title: "Share by link", children: [
    h("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    h("ul", { class: "links", children: ja.value.map((n) => $("li", { children: [
      h("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      h("code", { children: n.address }),
      $("span", { class: "buttons", children: [
        h("button", { onClick: () => {
          $i(n.address);
        }, children: "Copy" }),
        h("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        h("button", { onClick: () => yt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && h(Oi, { text: n.address })
    ] }, n.id)) }),
    $("footer", { children: [
      h("button", { onClick: () => yt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      h("button", { onClick: () => yt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function Gi() {
  let e = wt(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    Si({ do: "save", name: n }), Ue.value = null, un(`Saving the version “${n}”.`);
  };
  return $(ze, { title: "Save a version", children: [
    h("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    $("label", { class: "line", children: [
      h("span", { children: "Name" }),
      h("span", { class: "field", children: h("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    h("footer", { children: h("button", { onClick: t, children: "Save" }) })
  ] });
}
var re = _e(null);
function Bi() {
  let e = Ai.value?.head, t = wt(null), n = (l) => t.current?.querySelector(`[name=${l}]`)?.value ?? "", a = () => {
    re.value = 0;
    let [l, r] = [Number(n("width")), Number(n("height"))];
    Ci("picture", { format: n("format"), width: l, height: r, batches: Number(n("batches")) }, (o) => {
      o.url ? (re.value = null, ln(o.name, o.url), Ue.value = null) : re.value = o.progress ?? 0;
    }, (o) => {
      re.value = null, un(o, "warn");
    });
  };
  return $(ze, { title: "Save the picture", children: [
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
      h("button", { onClick: () => Ya("command"), children: "Copy the command" }),
      h("button", { disabled: re.value !== null, onClick: a, children: re.value === null ? "Render and save" : `${Li(re.value * 100)} %` })
    ] })
  ] });
}
function Ki() {
  switch (Ue.value) {
    case "help":
      return h(Hi, {});
    case "palette":
      return h(Di, {});
    case "share":
      return h(Wi, {});
    case "save":
      return h(Gi, {});
    case "picture":
      return h(Bi, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import {
  act as _i,
  colorText as Za,
  cost as zi,
  css as Xi,
  Field as Qi,
  groups as Yi,
  hovered as xt,
  Icon as ji,
  lamps as Ja,
  output as el,
  pickRow as Zi,
  select as Ji,
  selection as tl,
  switchOn as es,
  three as ts,
  typeGroupLevel as ns,
  typeLevel as as
} from "./desk.js";
import { jsx as Y, jsxs as cn } from "./desk.js";
function ls() {
  return cn("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    Y("span", {}),
    Y("span", { children: "Name" }),
    Y("span", { children: "Level" }),
    Y("span", { children: "lm" }),
    Y("span", { children: "White" })
  ] });
}
function os({ row: e, index: t, count: n }) {
  let a = e.kind === "lamp" ? Ja.get(e.id) : void 0, l = e.kind === "group" ? Yi.get(e.id) : void 0, r = a ?? l;
  if (!r) return null;
  let o = tl.value?.kind === e.kind && tl.value.ids.includes(e.id), i = a ? a.flux * el(a) : (l?.lamps ?? []).reduce((s, p) => {
    let u = Ja.get(p);
    return s + (u ? u.flux * el(u) : 0);
  }, 0), c = xt.value?.kind === e.kind && xt.value.id === e.id;
  return cn(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${o ? "selected" : ""} ${r.on ? "" : "off"} ${c ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => xt.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => xt.value = null,
      children: [
        Y("button", { class: "icon power", "aria-pressed": r.on, "aria-label": `${r.name} on`, onClick: () => es(e, !r.on), children: Y(ji, { name: "power" }) }),
        Y("button", { class: "row-name", "aria-pressed": o, title: a ? zi(a) : void 0, onClick: (s) => Zi(s, e.kind, e.id), onDblClick: () => _i("frame"), children: Y("span", { children: r.name }) }),
        Y(
          Qi,
          {
            label: `${r.name} level`,
            quantity: "level",
            value: r.level,
            flux: a?.flux,
            step: 0.01,
            set: (s) => a ? as([e.id], s) : ns(e.id, s)
          }
        ),
        Y("span", { class: "lumens", children: ts(i) }),
        a ? cn("button", { class: "tint", "aria-label": `${r.name} colour: ${Za(a)}`, onClick: () => Ji("lamp", e.id), children: [
          Y("i", { class: "swatch", style: { background: Xi(a.swatch) } }),
          Za(a)
        ] }) : Y("span", {})
      ]
    }
  );
}

// src/later/strip.tsx
import {
  act as nl,
  command as sl,
  digits as pn,
  fade as Mt,
  Field as rs,
  grids as al,
  Icon as Ie,
  looks as ll,
  luxText as ye,
  maintenance as is,
  meters as ol,
  select as rl,
  selection as Ct,
  signal as ss,
  status as dn,
  storeLook as us
} from "./desk.js";
import { Fragment as hs, jsx as M, jsxs as F } from "./desk.js";
var mn = ss("looks");
function cs() {
  return F("section", { class: "looks", "aria-label": "Looks", children: [
    F("header", { children: [
      M("h2", { children: "Looks" }),
      M("button", { class: "tab", onClick: () => mn.value = "meters", children: "Meters" }),
      M("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: us, children: M(Ie, { name: "plus" }) }),
      M("span", { class: "gap" }),
      F("label", { class: "tint", children: [
        "Fade",
        M(rs, { label: "Cross-fade", quantity: "seconds", value: Mt.value, step: 0.5, set: (e) => Mt.value = Math.max(0, e(Mt.value)) })
      ] })
    ] }),
    F("ul", { children: [
      ll.all().map(([e, t], n) => F("li", { class: "look", children: [
        F("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => sl({ do: "look", id: e, what: "recall", seconds: Mt.peek() }), children: [
          t.picture && M("img", { src: t.picture, alt: "" }),
          M("span", { children: t.name })
        ] }),
        M(ps, { id: e, name: t.name })
      ] }, e)),
      !ll.ids.value.length && M("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function ps({ id: e, name: t }) {
  let n = `look-${e}`, a = (i) => {
    let c = i.getBoundingClientRect(), s = document.getElementById(n);
    s?.style.setProperty("left", `${Math.min(c.left, innerWidth - 296)}px`), s?.style.setProperty("bottom", `${innerHeight - c.top + 4}px`), s?.style.setProperty("top", "auto");
  }, l = { popovertarget: n }, r = () => document.getElementById(n)?.hidePopover(), o = (i, c = {}) => {
    r(), sl({ do: "look", id: e, what: i, ...c });
  };
  return F(hs, { children: [
    M("button", { class: "icon more", ...l, "aria-label": `More of ${t}`, onPointerDown: (i) => a(i.currentTarget), onFocus: (i) => a(i.currentTarget), children: M(Ie, { name: "more" }) }),
    F("div", { id: n, popover: "auto", class: "menu", children: [
      F("label", { class: "line", children: [
        M("span", { children: "Name" }),
        M("span", { class: "field", children: M("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (i) => o("rename", { name: i.currentTarget.value }) }) })
      ] }),
      M("button", { class: "item", onClick: () => o("update"), children: M("span", { children: "Update to what is set now" }) }),
      M("button", { class: "item", onClick: () => o("recall", { seconds: 0 }), children: M("span", { children: "Recall at once" }) }),
      M("button", { class: "item", onClick: () => o("remove"), children: M("span", { children: "Remove" }) })
    ] })
  ] });
}
var il = () => dn.value?.stage === "moving" || dn.value?.stage === "refining" || dn.value?.stage === "loading";
function ds() {
  let e = is.value;
  return F("section", { class: "readings", "aria-label": "Meters and grids", children: [
    F("header", { children: [
      M("h2", { children: "Meters" }),
      M("button", { class: "tab", onClick: () => mn.value = "looks", children: "Looks" }),
      M("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => nl("meter-tool"), children: M(Ie, { name: "meter" }) }),
      M("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => nl("grid"), children: M(Ie, { name: "grid" }) }),
      M("button", { onClick: Ua, title: "Save all figures as CSV", children: "CSV" }),
      M("span", { class: "gap" }),
      M("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${pn(e, 2)} maintained` })
    ] }),
    F("ul", { children: [
      ol.all().map(([t, n]) => {
        let a = n.lux, l = !a || a[1] > 0.02 * a[0] || il();
        return M("li", { children: F("button", { class: "reading", "aria-pressed": Ct.value?.kind === "meter" && Ct.value.ids.includes(t), onClick: () => rl("meter", t), children: [
          F("span", { class: "tint", children: [
            M(Ie, { name: "meter" }),
            n.name
          ] }),
          M("strong", { class: l ? "unsettled" : "", children: a ? ye(a[0] * e) : "…" }),
          F("small", { children: [
            a ? `±${ye(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind
          ] })
        ] }) }, `m${t}`);
      }),
      al.all().map(([t, n]) => {
        let a = n.target, l = a && n.mean != null && n.uniformity != null && n.mean * e >= a.lux && n.uniformity >= a.uniformity;
        return M("li", { children: F("button", { class: "reading", "aria-pressed": Ct.value?.kind === "grid" && Ct.value.ids.includes(t), onClick: () => rl("grid", t), children: [
          F("span", { class: "tint", children: [
            M(Ie, { name: "grid" }),
            n.name,
            " ",
            a && n.mean != null && M("b", { class: l ? "met" : "missed", children: l ? "✓" : "✗" })
          ] }),
          M("strong", { class: il() ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${ye(n.mean * e)}${n.error == null ? "" : ` ±${ye(n.error * e, !1)}`}` }),
          F("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : pn(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : ye(n.min * e, !1),
            " to",
            " ",
            n.max == null ? "…" : ye(n.max * e, !1),
            a ? ` · wants ${ye(a.lux)}, U₀ ${pn(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !ol.ids.value.length && !al.ids.value.length && M("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function ms() {
  return F("div", { class: "strip-parts", "data-tab": mn.value, children: [
    M(cs, {}),
    M(ds, {})
  ] });
}

// src/later/menus.tsx
import {
  digits as bs,
  display as gs,
  Field as ul,
  go as fs,
  houseLights as hn,
  Item as ke,
  Range as vs,
  show as bn,
  theme as cl,
  walking as ys
} from "./desk.js";
import { Fragment as gn, jsx as P, jsxs as me } from "./desk.js";
function ks() {
  let e = et();
  return me(gn, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((t) => P(ke, { id: t }, t)),
    P("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((t) => P(ke, { id: `preset-${t}` }, t)),
    P("hr", {}),
    e.length > 0 && P("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    e.map(({ name: t, camera: n }, a) => P("button", { class: "item", onClick: () => fs(n, t), children: P("span", { children: t }) }, a)),
    e.length > 0 && P("hr", {}),
    P(ke, { id: "walking", label: ys.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    P(ke, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((t) => P(ke, { id: `hands-${t}` }, t))
  ] });
}
var ws = ["linear", "reinhard", "filmic"];
function xs() {
  let e = gs.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return me(gn, { children: [
    me("fieldset", { children: [
      P("legend", { children: "Tone curve" }),
      P("div", { class: "segments", children: ws.map((n) => P("button", { "aria-pressed": e.tone === n, onClick: () => bn({ tone: n }), children: n }, n)) })
    ] }),
    me("fieldset", { children: [
      P("legend", { children: "White balance" }),
      me("label", { class: "line", children: [
        P("span", { children: "White" }),
        P(ul, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => bn({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      me("label", { class: "line", children: [
        P("span", { children: "Tint" }),
        P(ul, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => bn({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    P("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => P(ke, { id: n }, n))
  ] });
}
function Ms() {
  return me(gn, { children: [
    me("label", { class: "line", children: [
      P("span", { children: "House lights" }),
      P(vs, { label: "House lights", value: hn.value, text: `${bs(hn.value * 100)} %`, on: (e) => hn.value = Math.max(0.3, e) })
    ] }),
    P("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => P("button", { "aria-pressed": cl.value === e, onClick: () => cl.value = e, children: e }, e)) }),
    P("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => P(ke, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as St, cut as Cs, digits as pl, edit as dl, go as Ss, Icon as Xe, Range as $s, setCut as Ls, storeView as Ps, viewName as Ts, views as Es } from "./desk.js";
import { jsx as _, jsxs as fn } from "./desk.js";
function Vs() {
  let e = Es.all();
  return fn("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    _("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => St("home"), children: _(Xe, { name: "home" }) }),
    _("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => St("frame"), children: _(Xe, { name: "frame" }) }),
    _("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => St("back"), children: _(Xe, { name: "back" }) }),
    _("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => St("forth"), children: _(Xe, { name: "forth" }) }),
    _("span", { class: "divide" }),
    e.map(([t, n], a) => fn(
      "button",
      {
        class: "saved-view",
        "aria-pressed": Ts.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click to rename, Delete to remove`,
        onClick: () => Ss(n, n.name ?? "view"),
        onDblClick: () => {
          let l = prompt("Name of the view", n.name ?? "");
          l && dl(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (l) => {
          l.key === "Delete" && (l.stopPropagation(), dl(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          _("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    _("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: Ps, children: _(Xe, { name: "plus" }) })
  ] });
}
function As() {
  let e = Cs.value;
  if (!e) return null;
  let t = e.height === null ? `${pl(e.value, 2)} m` : `at ${pl(e.height, 2)} m`;
  return fn("label", { class: "cut", "data-scroll": !0, children: [
    _("span", { children: "Cut" }),
    _(
      $s,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => Ls(n * e.most)
      }
    ),
    _("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as Is, useRef as qs } from "./desk.js";
import { jsx as ml } from "./desk.js";
function Rs() {
  let e = qs(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let l = n.type === "pointerup" || n.type === "pointercancel";
    if (!l && !a.hasPointerCapture(n.pointerId)) return;
    let r = a.getBoundingClientRect(), o = (s) => Math.max(-1, Math.min(1, s)), i = l ? 0 : o((n.clientX - r.left) / (r.width / 2) - 1), c = l ? 0 : o(1 - (n.clientY - r.top) / (r.height / 2));
    e.current?.style.setProperty("transform", `translate(${i * 28}px, ${-c * 28}px)`), Is(c, i);
  };
  return ml("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: ml("span", { ref: e }) });
}

// src/later/what.tsx
import {
  addMeter as Fs,
  aim as Hs,
  chosenLamps as hl,
  closeWhat as bl,
  digits as Ns,
  hovered as gl,
  Icon as Ds,
  luxText as he,
  nameOf as Os,
  select as Ws,
  useEffect as Gs,
  useRef as Bs,
  viewSize as Ks,
  what as Us
} from "./desk.js";
import { jsx as G, jsxs as ee } from "./desk.js";
var we = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], _s = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function zs() {
  let e = Us.value, t = Bs(null);
  if (Gs(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = Ks.value, l = [...e.lamps].sort((u, g) => we(g) - we(u)), r = l.reduce((u, g) => u + we(g), 0) || 1, o = l.slice(0, 9), i = r - o.reduce((u, g) => u + we(g), 0), c = Math.max(8, Math.min(e.x + 12, n - 332)), s = Math.max(8, Math.min(e.y + 12, a - 120 - 28 * Math.min(l.length, 10))), p = e.lux ? `${he(e.lux[0])} ±${he(e.lux[1], !1)}` : "Measuring…";
  return ee(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${c}px`, top: `${s}px` },
      onKeyDown: (u) => {
        u.key === "Escape" && (u.stopPropagation(), bl(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        ee("header", { children: [
          G("strong", { class: e.done ? "" : "unsettled", children: p }),
          G("span", { class: "quiet", children: "what lights this" }),
          G("button", { class: "icon", "aria-label": "Close", onClick: bl, children: G(Ds, { name: "close" }) })
        ] }),
        ee("ol", { children: [
          o.map((u) => G(
            "li",
            {
              onPointerEnter: () => gl.value = { kind: "lamp", id: u.id },
              onPointerLeave: () => gl.value = null,
              children: ee("button", { class: "row", onClick: () => Ws("lamp", u.id), children: [
                G("span", { class: "name", children: Os("lamp", u.id) }),
                ee("span", { class: "figure", children: [
                  Ns(100 * we(u) / r, we(u) / r < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                ee("span", { class: "figure lux", children: [
                  he(we(u)),
                  " ±",
                  he(_s(u), !1)
                ] }),
                ee("span", { class: "bar", "aria-hidden": "true", children: [
                  G("i", { class: "direct", style: { width: `${100 * u.direct[0] / r}%` } }),
                  G("i", { class: "indirect", style: { width: `${100 * u.indirect[0] / r}%` } }),
                  G("i", { class: "caustic", style: { width: `${100 * u.caustic[0] / r}%` } })
                ] }),
                ee("span", { class: "spoken", children: [
                  "direct ",
                  he(u.direct[0]),
                  ", indirect ",
                  he(u.indirect[0]),
                  ", caustic",
                  " ",
                  he(u.caustic[0])
                ] })
              ] })
            },
            u.id
          )),
          l.length > o.length && ee("li", { class: "quiet", children: [
            "and ",
            l.length - o.length,
            " others, ",
            he(i),
            " together"
          ] }),
          !l.length && G("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        ee("footer", { children: [
          G("span", { class: "key direct", children: "direct" }),
          G("span", { class: "key indirect", children: "indirect" }),
          G("span", { class: "key caustic", children: "caustic" }),
          G("span", { class: "gap" }),
          hl.value.length > 0 && G("button", { onClick: () => Hs(hl.peek(), e.hit.point), children: "Aim here" }),
          G("button", { onClick: () => Fs(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  uo as Compare,
  As as CutBar,
  Xo as Gizmo,
  oi as Inspector,
  hi as Legend,
  Ms as PageItems,
  xs as SeeingItems,
  ls as SheetHead,
  os as SheetRow,
  Ki as Sheets,
  ms as Strip,
  ks as ViewItems,
  Vs as ViewStrip,
  Rs as WalkPad,
  zs as What
};
