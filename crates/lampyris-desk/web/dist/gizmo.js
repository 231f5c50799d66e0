// src/later/actions.ts
import {
  addMeter as il,
  adding as sl,
  aim as ul,
  ask as cl,
  back as pl,
  candles as fn,
  chosenLamps as se,
  clearSolo as ml,
  command as vn,
  compareHeld as dl,
  copyAlong as hl,
  copyText as bl,
  deselect as gl,
  each as Pt,
  edit as Et,
  exposeBy as yn,
  falseColor as fl,
  fine as kn,
  forth as vl,
  frameSelection as yl,
  go as kl,
  goHome as wl,
  goInside as xl,
  goPreset as Ml,
  handles as wn,
  hands as Cl,
  here as Sl,
  highlight as $l,
  history as xn,
  lampMarks as Mn,
  lamps as Ze,
  listing as Cn,
  lookOnly as Sn,
  panels as $n,
  PRESETS as Ll,
  register as Tl,
  removeLamps as Pl,
  say as Qe,
  scene as El,
  selection as An,
  send as Vl,
  sheet as He,
  show as Al,
  soloSelection as ql,
  spot as De,
  startTool as xe,
  stepSelection as Ln,
  storeLook as Il,
  storeView as Rl,
  theme as Tn,
  things as Pn,
  titleOf as qn,
  toggleFalse as Fl,
  toggleWipe as Nl,
  travel as En,
  views as Hl,
  walking as Tt,
  whyNot as Q
} from "./desk.js";
var ie = () => Q() ?? (se.value.length ? null : "Select a lamp first.");
function Dl() {
  let e = se.peek(), t = !e.some((n) => Ze.get(n)?.on);
  Et(`${qn(e)} ${t ? "on" : "off"}`, { lamps: Pt(e, { on: t }) });
}
function Ol() {
  let e = se.peek(), t = !e.every((n) => Ze.get(n)?.parked);
  Et(`${t ? "Park" : "Unpark"} ${qn(e)}`, { lamps: Pt(e, { parked: t }) });
}
function Vn(e) {
  let t = An.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : Pn.ids.peek().filter((a) => Pn.get(a)?.hidden);
  if (!n.length) return Qe(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Et(e ? "Hide things" : "Show hidden things", { things: Pt(n, { hidden: e }) });
}
function Wl() {
  let e = se.peek()[0], t = Ze.get(e)?.place, n = Sl();
  if (!t?.position || !t.direction || !n) return Qe("Select a lamp that has a direction.", "warn");
  let { position: a, direction: l } = t;
  kl({ ...n, eye: a, target: [a[0] + l[0], a[1] + l[1], a[2] + l[2]], height: null, near: null }, "from the lamp");
}
function Gl() {
  cl("command", {}, (e) => {
    bl(e.text);
  });
}
var Bl = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Kl = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, Ul = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: yl },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: wl },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: xl },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: pl },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: vl },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Rl, why: Q },
  ...Ll.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Kl[e],
    keys: `Shift+${t + 1}`,
    run: () => Ml(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      Tt.value = Tt.peek() === "walk" ? "fly" : "walk", Qe(Tt.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: Wl, why: ie },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => Ln(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => Ln(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => xe("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => An.value = { kind: "lamp", ids: Ze.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: gl },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: Dl, why: ie },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: ql, why: () => se.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: ml },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => $l(!0), why: ie },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Ol, why: ie },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => xe("aim"), why: ie },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => De.peek() && ul(se.peek(), De.peek().point), why: ie },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => wn.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => wn.value = "turn" },
  ...Bl.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: Q,
    run: () => {
      sl.value = e, xe("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => hl(se.peek(), 1, [0.5, 0, 0]), why: ie },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => Pl(se.peek()), why: ie },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => Vn(!0), why: Q },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => Vn(!1), why: Q },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => vn({ do: "undo" }), why: () => Q() ?? (xn.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => vn({ do: "redo" }), why: () => Q() ?? (xn.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => He.value = "save", why: Q },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => He.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Gl },
  { id: "share", group: "Work", label: "Share by link", run: () => He.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: Fl },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = fl();
      Al({ false_color: { ...e, quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => yn(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => yn(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => Vl({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => dl(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: Nl },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: Q, run: () => De.peek() ? il(De.peek().point, De.peek().normal) : xe("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => xe("meter"), why: Q },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => xe("grid"), why: Q },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => fn.value = fn.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Il, why: Q },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => Qe("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => $n.value = !$n.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => Cn.value = Cn.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => En.value = En.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => Mn.value = !Mn.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => kn.value = !kn.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => Tn.value = Tn.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => Sn.value = !Sn.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => Cl.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => He.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => He.value = "palette" }
];
Tl(Ul);
function Je() {
  return [...(El.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...Hl.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as zl, comparing as _l, digits as Xl, fitted as Yl, useEffect as jl, useRef as Ql, viewSize as Zl, wipeAt as Vt } from "./desk.js";
import { Fragment as eo, jsx as At, jsxs as to } from "./desk.js";
function Jl() {
  let e = _l.value, t = zl.value, n = Ql(null);
  if (jl(() => {
    let s = n.current;
    !s || !t || (s.width = t.picture.width, s.height = t.picture.height, s.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = Zl.value, l = Vt.value, r = Yl(t.picture.width, t.picture.height), o = Math.max(0, Math.min(1, (l * a - r.x) / (t.picture.width * r.scale))), i = (s) => {
    let p = s.currentTarget;
    if (s.stopPropagation(), s.type === "pointerdown") p.setPointerCapture(s.pointerId);
    else if (p.hasPointerCapture(s.pointerId)) {
      let c = p.parentElement.getBoundingClientRect();
      Vt.value = Math.max(0, Math.min(1, (s.clientX - c.left) / c.width));
    }
  }, u = (s) => {
    let p = { ArrowLeft: -0.02, ArrowRight: 0.02 }[s.key];
    p && (s.stopPropagation(), s.preventDefault(), Vt.value = Math.max(0, Math.min(1, l + p)));
  };
  return to(eo, { children: [
    At(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * o}% 0 0)` : "none" }
      }
    ),
    At("span", { class: "tag left", children: "before" }),
    e === "wipe" && At(
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
        "aria-valuetext": `${Xl(l * 100)} % before`,
        style: { left: `${100 * l}%` },
        onPointerDown: i,
        onPointerMove: i,
        onKeyDown: u
      }
    )
  ] });
}

// src/later/handles.tsx
import {
  chosenLamps as Wn,
  computed as Gn,
  editor as po,
  effect as mo,
  fitted as ho,
  Gesture as bo,
  handles as go,
  lamps as nt,
  lookOnly as fo,
  pinhole as vo,
  placed as yo,
  positionOf as Dn,
  positions as ko,
  role as wo,
  selection as On,
  shown as xo,
  titleOf as Mo,
  tool as Co,
  useEffect as So,
  useRef as $o,
  viewSize as Lo
} from "./desk.js";

// src/later/gizmo.ts
import { project as In, ray as no } from "./desk.js";
import { across as ao, add as ee, cross as lo, distance as oo, dot as ue, length as ro, normal as et, scale as te, sub as Me, turn as io } from "./desk.js";
var so = "http://www.w3.org/2000/svg", qt = 84, ge = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], tt = ["x", "y", "z"], Rn = 0.1, uo = 5 * Math.PI / 180, Fn = 48;
function Hn(e, t) {
  let n = (d, b, f) => {
    let w = document.createElementNS(so, d);
    return w.setAttribute("class", f), b.append(w), w;
  }, a = (d, b, f) => {
    let w = n("g", e, `handle ${d} ${tt[b] ?? ""}`);
    return w.setAttribute("data-handle", f), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, l = n("path", e, "aim-line"), r = ge.map((d, b) => a("ring", b, `ring-${tt[b]}`)), o = ge.map((d, b) => a("plane", b, `plane-${tt[b]}`)), i = ge.map((d, b) => a("arrow", b, `move-${tt[b]}`)), u = a("centre", -1, "move-view"), s = a("aim", -1, "aim"), p = n("text", e, "handle-text"), c = (d, b) => {
    let [f, w, L] = In(d.hole, b);
    return L < 0.02 && !d.hole.parallel ? null : [d.fit.x + f * d.fit.scale, d.fit.y + w * d.fit.scale];
  }, g = (d, b) => {
    let f = In(d.hole, b)[2];
    return qt / d.fit.scale * d.hole.pixel * (d.hole.parallel ? 1 : Math.max(f, 0.02));
  }, m = (d, b, f = !1) => {
    let w = b.filter((C) => C !== null), L = w.length < b.length || w.length < 2 ? "" : `M${w.map((C) => `${C[0].toFixed(1)} ${C[1].toFixed(1)}`).join("L")}${f ? "Z" : ""}`;
    d.setAttribute("d", L);
  }, y = (d, b, f) => {
    d.setAttribute("d", b ? `M${b[0] - f} ${b[1]}a${f} ${f} 0 1 0 ${2 * f} 0a${f} ${f} 0 1 0 ${-2 * f} 0` : "");
  }, k = (d, b) => d.forEach((f) => f.group.classList.toggle("gone", !b));
  function R(d, b) {
    let f = d.position, w = c(b, f), L = g(b, f), C = d.mode === "move";
    k([...i, ...o, u], C && w !== null), k(r, !C && w !== null && d.direction !== null);
    let _ = d.aim ?? (d.direction ? ee(f, te(d.direction, 3 * L)) : null);
    if (k([s], _ !== null && w !== null), !w) {
      l.setAttribute("d", "");
      return;
    }
    ge.forEach((K, N) => {
      let I = c(b, ee(f, te(K, L))), he = I ? Math.hypot(I[0] - w[0], I[1] - w[1]) < 12 : !0;
      if (i[N].group.classList.toggle("gone", !C || he), I && C) {
        let [be, Fe] = [(I[0] - w[0]) / qt, (I[1] - w[1]) / qt], je = Math.hypot(be, Fe) || 1, [re, Ne] = [be / je, Fe / je], Lt = [w[0] + 14 * re, w[1] + 14 * Ne];
        m(i[N].hit, [Lt, I]), i[N].seen.setAttribute("d", `M${Lt[0].toFixed(1)} ${Lt[1].toFixed(1)}L${I[0].toFixed(1)} ${I[1].toFixed(1)}M${(I[0] - 9 * re - 4.5 * Ne).toFixed(1)} ${(I[1] - 9 * Ne + 4.5 * re).toFixed(1)}L${I[0].toFixed(1)} ${I[1].toFixed(1)}L${(I[0] - 9 * re + 4.5 * Ne).toFixed(1)} ${(I[1] - 9 * Ne - 4.5 * re).toFixed(1)}`);
      }
      let [Ie, Re] = [ge[(N + 1) % 3], ge[(N + 2) % 3]], j = Math.abs(ue(K, b.hole.parallel ? b.hole.forward : et(Me(f, b.hole.eye)))) < 0.15;
      o[N].group.classList.toggle("gone", !C || j);
      let Ye = (be, Fe) => c(b, ee(f, ee(te(Ie, be * L), te(Re, Fe * L)))), gn = [Ye(0.3, 0.3), Ye(0.5, 0.3), Ye(0.5, 0.5), Ye(0.3, 0.5)];
      if (m(o[N].hit, gn, !0), m(o[N].seen, gn, !0), !C) {
        let be = Array.from({ length: Fn + 1 }, (Fe, je) => {
          let re = 2 * Math.PI * je / Fn;
          return c(b, ee(f, ee(te(Ie, Math.cos(re) * L), te(Re, Math.sin(re) * L))));
        });
        m(r[N].hit, be), m(r[N].seen, be);
      }
    }), y(u.hit, w, 13), y(u.seen, w, 7);
    let q = _ && c(b, _);
    m(l, [w, q]), y(s.hit, q, 16), s.seen.setAttribute("d", q ? `M${q[0] - 8} ${q[1]}h16M${q[0]} ${q[1] - 8}v16M${q[0] - 5} ${q[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let B = t.effect(() => {
    let d = t.target.value, b = t.view.value;
    e.classList.toggle("empty", !d || !b), d && b && R(d, b);
  }), dn = (d, b, f) => no(d.hole, (b.clientX - f.left - d.fit.x) / d.fit.scale, (b.clientY - f.top - d.fit.y) / d.fit.scale);
  function qe(d, b, f) {
    d.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let L = t.view.peek();
      if (!L || !t.target.peek()) return;
      let C = e.getBoundingClientRect(), _ = f(L), q = t.hold(b), K = dn(L, w, C);
      _(K, !1, { ...q, move: () => {
      }, turn: () => {
      } }), d.setPointerCapture(w.pointerId), d.classList.add("held");
      let N = (j) => {
        p.textContent = _(dn(L, j, C), j.ctrlKey || j.metaKey, q), p.setAttribute("x", String(j.clientX - C.left + 16)), p.setAttribute("y", String(j.clientY - C.top - 12));
      }, I = (j) => {
        d.removeEventListener("pointermove", N), d.removeEventListener("pointerup", he), d.removeEventListener("pointercancel", Ie), removeEventListener("keydown", Re, !0), d.classList.remove("held"), p.textContent = "", j ? q.end() : q.cancel();
      }, he = () => I(!0), Ie = () => I(!1), Re = (j) => {
        j.key === "Escape" && (j.stopPropagation(), I(!1));
      };
      d.addEventListener("pointermove", N), d.addEventListener("pointerup", he), d.addEventListener("pointercancel", Ie), addEventListener("keydown", Re, !0);
    });
  }
  let St = (d, b, f) => f ? Math.round(d / b) * b : d, $t = (d) => d.map((b) => b.toFixed(2)).join("  ") + " m";
  ge.forEach((d, b) => {
    qe(i[b].group, "move", () => {
      let f = t.target.peek().position, w = null;
      return (L, C, _) => {
        let q = co(f, d, L);
        w ??= q;
        let K = te(d, St(q - w, Rn, C));
        return _.move(K), $t(K);
      };
    }), qe(o[b].group, "move", () => hn(d)), qe(r[b].group, "turn", () => {
      let f = t.target.peek(), w = f.direction, L = { at: null };
      return (C, _, q) => {
        let K = Nn(f.position, d, C), N = K && et(Me(K, f.position), ao(d));
        if (!N) return "";
        L.at ??= N;
        let I = Math.atan2(ue(d, lo(L.at, N)), ue(L.at, N)), he = St(I, uo, _);
        return q.turn(et(io(w, d, he)), null), `${(he * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), qe(u.group, "move", (d) => hn(d.hole.forward)), qe(s.group, "aim", (d) => {
    let b = t.target.peek(), f = b.aim ?? ee(b.position, te(b.direction, 3 * g(d, b.position))), w = bn(f, d.hole.forward);
    return (L, C, _) => {
      let q = w(L, C), K = ee(f, q);
      return oo(K, b.position) > 1e-3 && _.turn(et(Me(K, b.position)), K), $t(K);
    };
  });
  function hn(d) {
    let b = bn(t.target.peek().position, d);
    return (f, w, L) => {
      let C = b(f, w);
      return L.move(C), $t(C);
    };
  }
  function bn(d, b) {
    let f = null;
    return (w, L) => {
      let C = Nn(d, b, w);
      return C ? (f ??= C, Me(C, f).map((_) => St(_, Rn, L))) : [0, 0, 0];
    };
  }
  return { stop: B };
}
function co(e, t, n) {
  let a = Me(e, n.origin), l = ue(t, n.direction), r = 1 - l * l;
  return r < 1e-6 ? 0 : (l * ue(n.direction, a) - ue(t, a)) / r;
}
function Nn(e, t, n) {
  let a = ue(t, n.direction);
  if (Math.abs(a) < 1e-4 * ro(t)) return null;
  let l = ue(Me(e, n.origin), t) / a;
  return l < 0 || l > 1e3 ? null : ee(n.origin, te(n.direction, l));
}

// src/later/handles.tsx
import { jsx as qo } from "./desk.js";
var To = Gn(() => {
  if (On.value?.kind !== "lamp" && On.value?.kind !== "group" || fo.value || wo.value === "watch" || !po.value.you || Co.value === "aim") return null;
  let e = Wn.value.filter((n) => Dn(nt.get(n)));
  if (!e.length) return null;
  let t = nt.get(e[e.length - 1]);
  return {
    position: Dn(t),
    direction: t.place?.direction ?? null,
    aim: t.place?.aim ?? null,
    mode: go.value
  };
}), Po = Gn(() => {
  let e = xo.value;
  if (Lo.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: vo(e.camera, t, n), fit: ho(t, n) };
}), Eo = () => Wn.peek().filter((e) => nt.entry(e)), Vo = {
  effect: mo,
  target: To,
  view: Po,
  hold(e) {
    let t = Eo(), n = e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn", a = new bo(`${n} ${Mo(t)}`), l = ko(t);
    return {
      move: (r) => a.set(yo(t, r, l)),
      turn: (r, o) => {
        let i = Object.fromEntries(
          t.filter((u) => nt.entry(u)?.shown.peek().place?.direction).map((u) => [u, { place: { direction: r, aim: o } }])
        );
        a.set({ lamps: i });
      },
      end: () => a.end(),
      cancel: () => a.cancel()
    };
  }
};
function Ao() {
  let e = $o(null);
  return So(() => Hn(e.current, Vo).stop, []), qo("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as qa, deselect as Dr, Icon as Zt, selection as Or, signal as Wr } from "./desk.js";

// src/later/measure.tsx
import {
  deselect as Un,
  digits as fe,
  edit as lt,
  grids as Do,
  Icon as zn,
  length as $e,
  luxText as Oe,
  maintenance as It,
  meters as Oo,
  selection as _n,
  spacing as Wo
} from "./desk.js";

// src/later/parts.tsx
import { Field as Bn, Gesture as Io, Range as Ro, stroke as Fo, useRef as No } from "./desk.js";
import { jsx as ne, jsxs as at } from "./desk.js";
function V({ title: e, note: t, children: n }) {
  return at("section", { class: "part", "aria-label": e, children: [
    at("h3", { children: [
      e,
      t && ne("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function W(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function A(e) {
  return at("label", { class: "line", children: [
    ne("span", { children: e.label }),
    ne(Bn, { ...e, label: e.name ?? e.label })
  ] });
}
function Ho(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function Z({ label: e, names: t, quantity: n, value: a, set: l, step: r, disabled: o }) {
  let i = t ?? ["X", "Y", "Z"];
  return at("div", { class: "line", role: "group", "aria-label": e, children: [
    ne("span", { children: e }),
    ne("span", { class: "triple", children: i.map((u, s) => ne(
      Bn,
      {
        label: `${e} ${u}`,
        quantity: n,
        value: a[s],
        text: Ho(a[s], n),
        step: r,
        disabled: o,
        set: (p) => l(s, p)
      },
      u
    )) })
  ] });
}
function Ce({ label: e, name: t, value: n, text: a, patch: l, reset: r, notch: o, class: i, style: u, disabled: s }) {
  let p = No(null), c = (m) => () => {
    p.current?.[m](), p.current = null;
  }, g = (m) => p.current ? p.current.set(l(m)) : Fo(e + t, t, l(m));
  return ne(
    Ro,
    {
      label: e,
      value: n,
      text: a,
      notch: o,
      class: i,
      gradient: u,
      disabled: s,
      begin: () => p.current = new Io(t),
      on: g,
      end: c("end"),
      cancel: c("cancel"),
      reset: r === void 0 ? void 0 : () => g(r)
    }
  );
}
function Se({ value: e, label: t, set: n }) {
  return ne("span", { class: "field name-field", children: ne(
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
var ae = (e, t, n) => e.map((a, l) => l === t ? n(a) : a);

// src/later/measure.tsx
import { Fragment as Rt, jsx as T, jsxs as U } from "./desk.js";
var Go = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["camera", "toward the camera"]];
function Xn() {
  let e = _n.value?.ids[0], t = Oo.get(e);
  if (!t) return T("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, l) => {
    let { lux: r, ...o } = { ...t, ...l };
    lt(`${t.name}: ${a}`, { meters: { [e]: o } });
  };
  return U(Rt, { children: [
    T("header", { class: "panel-head", children: T(Se, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    T("p", { class: "crumbs", children: t.lux ? `${Oe(t.lux[0] * It.value)} ±${Oe(t.lux[1] * It.value, !1)}` : "measuring" }),
    T("div", { class: "scroll", children: U(V, { title: "Meter", children: [
      U("label", { class: "line", children: [
        T("span", { children: "Measures" }),
        T("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: Go.map(([a, l]) => T("option", { value: a, children: l }, a)) })
      ] }),
      T(Z, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, l) => n("move", { point: ae(t.point, a, l) }) }),
      T(Z, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, l) => n("turn", { normal: ae(t.normal, a, l) }) }),
      U("button", { class: "plain full", onClick: () => {
        Un(), lt(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        T(zn, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var Kn = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function Yn() {
  let e = _n.value?.ids[0], t = Do.get(e);
  if (!t) return T("p", { class: "quiet empty", children: "This grid is gone." });
  let n = It.value, a = (i, u) => {
    let { name: s, corner: p, u: c, v: g, normal: m, columns: y, rows: k, target: R } = { ...t, ...u };
    lt(`${t.name}: ${i}`, { grids: { [e]: { name: s, corner: p, u: c, v: g, normal: m, columns: y, rows: k, target: R } } });
  }, l = () => {
    let i = Wo(Math.max($e(t.u), $e(t.v)));
    a("standard spacing", { columns: Math.max(1, Math.ceil($e(t.u) / i)), rows: Math.max(1, Math.ceil($e(t.v) / i)) });
  }, r = (i, u, s) => U(Rt, { children: [
    T("dt", { children: i }),
    T("dd", { children: u === null ? "…" : s(u) })
  ] }), o = t.target ?? { lux: 500, uniformity: 0.6 };
  return U(Rt, { children: [
    T("header", { class: "panel-head", children: T(Se, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    U("p", { class: "crumbs", children: [
      fe($e(t.u), 2),
      " × ",
      fe($e(t.v), 2),
      " m, ",
      fe(t.columns * t.rows),
      " points"
    ] }),
    U("div", { class: "scroll", children: [
      T(V, { title: "Figures", note: n === 1 ? "new" : `× ${fe(n, 2)}`, children: U("dl", { class: "figures", children: [
        r("Ē", t.mean, (i) => Oe(i * n)),
        r("E min", t.min, (i) => Oe(i * n)),
        r("E max", t.max, (i) => Oe(i * n)),
        r("U₀ = min / mean", t.uniformity, (i) => fe(i, 2)),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => fe(i, 2)),
        r("±", t.error, (i) => `${fe(i * 100, 1)} %`)
      ] }) }),
      U(V, { title: "Target", children: [
        U("label", { class: "line", children: [
          T("span", { children: "Class" }),
          U("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let u = Kn[Number(i.currentTarget.value)];
            a("target", { target: u ? { lux: u[1], uniformity: u[2] } : null });
          }, children: [
            T("option", { value: "", children: t.target ? "choose…" : "none" }),
            Kn.map(([i, u, s], p) => U("option", { value: p, children: [
              i,
              ": ",
              u,
              " lx, U₀ ",
              s
            ] }, i)),
            T("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        T(A, { label: "Ē at least", quantity: "lux", step: 50, value: o.lux, set: (i) => a("target", { target: { ...o, lux: i(o.lux) } }) }),
        T(A, { label: "U₀ at least", quantity: "share", step: 0.05, value: o.uniformity, set: (i) => a("target", { target: { ...o, uniformity: i(o.uniformity) } }) })
      ] }),
      U(V, { title: "Area", children: [
        T(Z, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, u) => a("move", { corner: ae(t.corner, i, u) }) }),
        T(A, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        T(A, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        T("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: l, children: "Spacing of the standard" }),
        U("button", { class: "plain full", onClick: () => {
          Un(), lt(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          T(zn, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as ye,
  chosenLamps as nr,
  copyAlong as ar,
  dot as Ot,
  edit as it,
  format as ra,
  groups as st,
  handles as ot,
  Icon as Te,
  lamps as Kt,
  layers as lr,
  normal as ia,
  output as sa,
  percent as Bt,
  placed as or,
  positionOf as ea,
  positions as rr,
  selection as Wt,
  signal as ua,
  spot as ir,
  sub as ta,
  titleOf as Ut,
  tool as sr,
  toLevel as na,
  toTravel as ur,
  typeLevel as Gt,
  up as cr,
  Fade as pr,
  Field as mr,
  wantLevel as aa,
  compass as ca,
  add as ut,
  scale as Pe,
  length as dr,
  Range as hr,
  strokeLevel as la,
  useRef as br
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as zo,
  digits as Qn,
  edit as _o,
  fromHex as Xo,
  hex as Yo,
  lamps as Zn,
  mired as ve,
  titleOf as jo
} from "./desk.js";

// src/later/white.ts
import { css as Bo, mired as Ft } from "./desk.js";
function Ko(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((r) => Math.max(0, r));
}
function Uo(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function jn(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (l, r) => {
    let o = Ft(e) + (Ft(t) - Ft(e)) * r / (n - 1);
    return Bo(Ko(...Uo(1e6 / o)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as Ht, jsx as H, jsxs as ce } from "./desk.js";
var We = 1800, Dt = 1e4, Qo = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], Zo = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], Jo = jn(We, Dt), Nt = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(Zn.get(n).color) }]))
}), er = (e) => {
  let t = 1e6 / (ve(We) + (ve(Dt) - ve(We)) * e);
  return Math.round(t / 10) * 10;
}, tr = (e) => (ve(e) - ve(We)) / (ve(Dt) - ve(We));
function Jn() {
  let e = zo.value, t = e.map((o) => Zn.get(o)?.color).filter((o) => o !== void 0);
  if (!t.length) return null;
  let n = W(t.map((o) => o.mode)), a = t[0], l = jo(e), r = (o, i) => _o(`${l}: ${o}`, Nt(e, i));
  return ce(Ht, { children: [
    ce("div", { class: "line", children: [
      H("span", { children: "Colour" }),
      H("div", { class: "segments", role: "group", "aria-label": "Colour by", children: Zo.map(([o, i]) => H("button", { "aria-pressed": n === o, onClick: () => r(`colour by ${i}`, () => ({ mode: o })), children: i }, o)) })
    ] }),
    n === "kelvin" && ce(Ht, { children: [
      ce("div", { class: "line slide", children: [
        H("span", { children: "White" }),
        H(
          Ce,
          {
            label: "Colour temperature",
            name: `${l}: white`,
            class: "mired",
            style: Jo,
            value: tr(a.kelvin),
            text: `${Qn(a.kelvin)} kelvin`,
            patch: (o) => Nt(e, () => ({ mode: "kelvin", kelvin: er(o) }))
          }
        )
      ] }),
      H(
        A,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: W(t.map((o) => o.kelvin)),
          step: 50,
          set: (o) => r("white", (i) => ({ mode: "kelvin", kelvin: o(i.kelvin) }))
        }
      ),
      H("div", { class: "whites", role: "group", "aria-label": "Whites", children: Qo.map(([o, i]) => H("button", { title: i, "aria-label": `${o} kelvin, ${i}`, onClick: () => r(`${o} K`, () => ({ mode: "kelvin", kelvin: o })), children: o }, o)) }),
      ce("div", { class: "line slide", children: [
        H("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        H(
          Ce,
          {
            label: "Tint, magenta to green",
            name: `${l}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${Qn(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (o) => Nt(e, () => ({ tint: Math.round((o * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      H(A, { label: "", name: "Tint, typed", quantity: "number", value: W(t.map((o) => o.tint)), step: 1, set: (o) => r("tint", (i) => ({ tint: Math.max(-50, Math.min(50, o(i.tint))) })) })
    ] }),
    n === "rgb" && ce(Ht, { children: [
      ce("label", { class: "line", children: [
        H("span", { children: "Colour" }),
        H("input", { type: "color", class: "pick", "aria-label": "Colour", value: Yo(a.rgb), onChange: (o) => r("colour", () => ({ mode: "rgb", rgb: Xo(o.currentTarget.value) })) })
      ] }),
      H(
        Z,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (o, i) => r("colour", (u) => ({ rgb: u.rgb.map((s, p) => p === o ? Math.max(0, i(s)) : s) }))
        }
      )
    ] }),
    n === "xy" && ce("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      H("span", { children: "x, y" }),
      H("span", { class: "triple", children: [0, 1].map((o) => H(
        A,
        {
          label: "xy"[o],
          quantity: "number",
          step: 1e-3,
          value: W(t.map((i) => i.xy[o])),
          set: (i) => r("chromaticity", (u) => ({ xy: u.xy.map((s, p) => p === o ? Math.max(0.01, Math.min(0.9, i(s))) : s) }))
        },
        o
      )) })
    ] }),
    n === null && H("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as zt, jsx as v, jsxs as D } from "./desk.js";
var Le = ua(1), rt = ua([1, 0, 0]), gr = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], ct = 180 / Math.PI;
function oa(e, t) {
  let { right: n, ahead: a } = ca(t), l = -Ot(e, t);
  return [Math.atan2(Ot(e, n), Ot(e, a)) * ct, Math.asin(Math.max(-1, Math.min(1, l))) * ct];
}
function fr(e, t, n) {
  let { right: a, ahead: l } = ca(n), [r, o] = [e / ct, t / ct], i = ut(Pe(a, Math.sin(r)), Pe(l, Math.cos(r)));
  return ia(ut(Pe(i, Math.cos(o)), Pe(n, -Math.sin(o))));
}
function vr({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction);
  return D("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    D("button", { "aria-pressed": sr.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => ye("aim"), children: [
      v(Te, { name: "aim" }),
      "Aim"
    ] }),
    v("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => ye("solo"), children: v(Te, { name: "solo" }) }),
    v("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => ye("from-lamp"), children: v(Te, { name: "eye" }) }),
    v("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => ye("frame"), children: v(Te, { name: "frame" }) }),
    v("span", { class: "gap" }),
    v("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => ye("park"), children: "Park" }),
    v("button", { class: "icon", "aria-label": `Remove ${Ut(e)}`, title: "Remove (Del)", onClick: () => ye("remove"), children: v(Te, { name: "bin" }) })
  ] });
}
function yr({ ids: e, all: t }) {
  let n = W(t.map((o) => o.level)), a = t.reduce((o, i) => o + i.flux * sa(i), 0), l = t.every((o) => o.free), r = e[e.length - 1];
  return D(V, { title: "Light", note: l ? "re-mix" : "re-trace", children: [
    D("div", { class: "line slide", children: [
      v("span", { children: "Level" }),
      v(kr, { id: r })
    ] }),
    D("label", { class: "line", children: [
      v("span", {}),
      v(
        mr,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: W(t.map((o) => o.flux)) ?? void 0,
          step: 0.01,
          set: (o) => Gt(e, o),
          open: aa.value,
          opened: () => aa.value = "",
          id: "level"
        }
      )
    ] }),
    v(
      A,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (o) => Gt(e, (i, u) => o(i * u) / u)
      }
    ),
    D("div", { class: "line", children: [
      v("span", { children: "Stops" }),
      v("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: gr.map(([o, i]) => v("button", { "aria-label": `${i} stop`, onClick: () => Gt(e, (u) => Math.min(1e3, u * 2 ** o)), children: i }, i)) })
    ] }),
    D("p", { class: "sum", children: [
      ra(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (st.get(t[0].group)?.level ?? 1) !== 1 && ` (${Bt(t[0].level)} % × ${Bt(st.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    v(Jn, {})
  ] });
}
function kr({ id: e }) {
  let t = br(null), n = Kt.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, l = (r) => () => {
    t.current?.[r](), t.current = null;
  };
  return v(
    hr,
    {
      label: "Level",
      value: ur(n.level),
      text: `${Bt(n.level)} %, ${ra(n.flux * sa(n), "flux")}`,
      begin: () => t.current = new pr(a),
      on: (r) => t.current ? t.current.to(na(r)) : la(a, na(r)),
      end: l("end"),
      cancel: l("cancel"),
      reset: () => la(a, 1)
    }
  );
}
function Ge(e, t, n) {
  let a = {};
  for (let l of e) {
    let r = Kt.get(l), o = n(r.place ?? {}, r);
    o && (a[l] = { place: o });
  }
  Object.keys(a).length && it(`${Ut(e)}: ${t}`, { lamps: a });
}
function wr({ ids: e, all: t }) {
  let n = (l) => W(t.map((r) => r.place?.[l] ?? null)), a = (l) => t.some((r) => r.place?.[l] != null);
  return !a("outer") && !a("radius") ? null : D(V, { title: "Beam", note: "re-trace", children: [
    a("outer") && D(zt, { children: [
      v(A, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (l) => Ge(e, "beam", (r) => r.outer == null ? null : { inner: Math.max(0.1, Math.min(r.outer, l(r.inner ?? r.outer))) }) }),
      v(A, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (l) => Ge(e, "beam", (r) => {
        if (r.outer == null) return null;
        let o = Math.max(0.2, Math.min(179, l(r.outer)));
        return { outer: o, inner: Math.min(r.inner ?? o, o) };
      }) })
    ] }),
    a("radius") && v(A, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (l) => Ge(e, "radius", (r) => r.radius == null ? null : { radius: Math.max(1e-3, l(r.radius)) }) })
  ] });
}
function xr({ ids: e, all: t }) {
  let n = t.filter((c) => ea(c) !== null);
  if (!n.length) return null;
  let a = n.map((c) => ea(c)), l = (c, g) => W(g.map((m) => Math.round(m[c] * 1e4) / 1e4)), r = t.filter((c) => c.place?.direction), o = cr.value, i = r.map((c) => oa(c.place?.direction, o).map((g) => Math.round(g * 10) / 10)), u = t.map((c) => c.place?.aim).filter((c) => !!c), s = (c, g) => {
    let m = rr(e), y = {};
    for (let [k, R] of m) {
      let B = [0, 0, 0];
      B[c] = g(R[c]) - R[c], Object.assign(y, or([k], B, m).lamps);
    }
    it(`Move ${Ut(e)}`, { lamps: y });
  }, p = (c, g) => Ge(e, c ? "tilt" : "pan", (m) => {
    if (!m.direction) return null;
    let y = oa(m.direction, o);
    y[c] = g(y[c]);
    let k = fr(y[0], Math.max(-90, Math.min(90, y[1])), o), R = m.aim && m.position ? dr(ta(m.aim, m.position)) : 0;
    return { direction: k, ...R && m.position ? { aim: ut(m.position, Pe(k, R)) } : {} };
  });
  return D(V, { title: "Place", note: "re-trace", children: [
    v(Z, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => l(c, a)), set: s }),
    r.length > 0 && D(zt, { children: [
      v(A, { label: "Pan", quantity: "angle", step: 1, value: W(i.map((c) => c[0])), set: (c) => p(0, c) }),
      v(A, { label: "Tilt", quantity: "angle", step: 1, value: W(i.map((c) => c[1])), set: (c) => p(1, c) }),
      v(
        Z,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: u.length ? [0, 1, 2].map((c) => l(c, u)) : [NaN, NaN, NaN],
          set: (c, g) => Ge(e, "aim", (m) => {
            if (!m.direction || !m.position) return null;
            let y = ae(m.aim ?? ut(m.position, Pe(m.direction, 2)), c, g);
            return { aim: y, direction: ia(ta(y, m.position)) };
          })
        }
      )
    ] }),
    D("div", { class: "line", children: [
      v("span", { children: "Handles" }),
      D("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        v("button", { "aria-pressed": ot.value === "move", onClick: () => ot.value = "move", children: "Move" }),
        v("button", { "aria-pressed": ot.value === "turn", onClick: () => ot.value = "turn", children: "Turn" })
      ] })
    ] }),
    r.length > 0 && ir.value && v("button", { class: "plain full", onClick: () => ye("aim-here"), children: "Aim at the last point" })
  ] });
}
function Mr({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : D(V, { title: "Copies along a line", children: [
    v(A, { label: "How many", quantity: "number", step: 1, value: Le.value, set: (n) => Le.value = Math.max(1, Math.min(100, Math.round(n(Le.value)))) }),
    v(Z, { label: "Step", quantity: "length", step: 0.05, value: rt.value, set: (n, a) => rt.value = ae(rt.value, n, a) }),
    D("button", { class: "plain full", onClick: () => ar(e, Le.value, rt.value), children: [
      v(Te, { name: "copy" }),
      Le.value === 1 ? "One copy" : `${Le.value} copies`
    ] })
  ] });
}
function pa() {
  let e = nr.value, t = e.map((o) => Kt.get(o)).filter((o) => !!o);
  if (!t.length) return v("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && st.get(n.group), l = Wt.value?.kind === "group" ? st.get(Wt.value.ids[0]) : void 0, r = n?.layer != null ? lr.value[n.layer] : void 0;
  return D(zt, { children: [
    v("header", { class: "panel-head", children: n ? v(Se, { label: "Name of the lamp", value: n.name, set: (o) => it(`Rename ${n.name}`, { lamps: { [e[0]]: { name: o } } }) }) : l ? v(Se, { label: "Name of the group", value: l.name, set: (o) => it(`Rename ${l.name}`, { groups: { [Wt.value.ids[0]]: { name: o } } }) }) : D("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    v("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((o) => o.on).length} of ${t.length} on` }),
    D("div", { class: "scroll", children: [
      v(vr, { ids: e, all: t }),
      v(yr, { ids: e, all: t }),
      v(V, { title: "Photometry", children: v("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      v(wr, { ids: e, all: t }),
      v(xr, { ids: e, all: t }),
      v(Mr, { ids: e, all: t }),
      v("p", { class: "cost", children: t.every((o) => o.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as _t,
  candles as pt,
  command as Cr,
  digits as dt,
  edit as ma,
  Field as Sr,
  filterOf as ga,
  go as $r,
  history as Lr,
  hovered as da,
  Icon as ht,
  layers as Tr,
  lookOnly as ha,
  maintenance as Ee,
  materials as Pr,
  percent as Er,
  scene as Vr,
  select as fa,
  signal as Ar,
  singleKeys as ba,
  sub as qr,
  things as Ir,
  travel as mt,
  Virtual as va
} from "./desk.js";
import { Fragment as Rr, jsx as x, jsxs as E } from "./desk.js";
function ya() {
  let e = Vr.value;
  if (!e) return null;
  let t = qr(e.bounds[1], e.bounds[0]);
  return E(Rr, { children: [
    E(V, { title: "Room", children: [
      E("p", { children: [
        t.map((n) => dt(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${dt(e.triangles)} triangles` : ""
      ] }),
      x("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && x("ul", { class: "buttons", children: e.cameras.map((n, a) => x("li", { children: x("button", { onClick: () => $r(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && E("details", { children: [
        E("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        x("ul", { class: "remarks", children: e.warnings.map((n) => x("li", { children: n }, n)) })
      ] })
    ] }),
    E(V, { title: "Figures", children: [
      E("label", { class: "line", children: [
        x("span", { children: "Maintenance" }),
        x(Sr, { label: "Maintenance factor", quantity: "share", value: Ee.value, step: 0.05, set: (n) => Ee.value = Math.max(0.1, Math.min(1, n(Ee.value))) })
      ] }),
      E("p", { class: "quiet", children: [
        Ee.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Ee.value === 1 && x("button", { class: "plain", onClick: () => Ee.value = 0.8, children: "0.80" })
      ] }),
      E("div", { class: "line", children: [
        x("span", { children: "Unit" }),
        E("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          x("button", { "aria-pressed": pt.value === "lx", onClick: () => pt.value = "lx", children: "lx, cd/m²" }),
          x("button", { "aria-pressed": pt.value === "fc", onClick: () => pt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    x(V, { title: "Layers of light", children: x("ul", { class: "layers", children: Tr.value.map((n, a) => E("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      x("i", { class: "dot", "aria-hidden": "true" }),
      x("span", { children: n.name || `layer ${a + 1}` }),
      x("small", { children: n.held ? "held" : Er(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    E(V, { title: "Hands", children: [
      E("div", { class: "line", children: [
        x("span", { children: "Faders" }),
        E("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          x("button", { "aria-pressed": mt.value === "square", onClick: () => mt.value = "square", children: "Square law" }),
          x("button", { "aria-pressed": mt.value === "linear", onClick: () => mt.value = "linear", children: "Even" })
        ] })
      ] }),
      E("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: ba.value, onChange: (n) => ba.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      E("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: ha.value, onChange: (n) => ha.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var bt = Ar("");
function ka({ label: e }) {
  return x("span", { class: "field filter", children: x("input", { type: "text", "aria-label": e, placeholder: "Filter", value: bt.value, onInput: (t) => bt.value = t.currentTarget.value }) });
}
function wa() {
  let e = ga(Ir, bt.value);
  return E("div", { class: "listing", children: [
    x(ka, { label: "Filter things" }),
    x(
      va,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => da.value = { kind: "thing", id: n }, onPointerLeave: () => da.value = null, children: [
            x("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => ma(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: x(ht, { name: a.hidden ? "eye-off" : "eye" }) }),
            x("button", { class: "row-name", onClick: () => fa("thing", n), children: x("span", { children: a.name }) }),
            x("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => ma(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: x(ht, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function xa() {
  let e = ga(Pr, bt.value);
  return E("div", { class: "listing", children: [
    x(ka, { label: "Filter materials" }),
    x(
      va,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row material", role: "listitem", children: [
            x("button", { class: "row-name", onClick: () => fa("material", n), children: x("span", { children: a.name }) }),
            E("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${dt(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function Ma() {
  let e = Lr.value;
  return E(V, { title: "History", children: [
    E("p", { children: [
      e.steps === 1 ? "One step" : `${dt(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => _t("undo"), children: [
      x(ht, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => _t("redo"), children: [
      x(ht, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    x("button", { class: "plain full", onClick: () => _t("save"), children: "Save a version with a name…" }),
    x("button", { class: "plain full", onClick: () => Cr({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as Xt,
  edit as La,
  fromHex as Fr,
  hex as Nr,
  Icon as Ca,
  materials as Ta,
  middle as Sa,
  select as Pa,
  selection as Ea,
  things as Yt
} from "./desk.js";
import { Fragment as Qt, jsx as S, jsxs as X } from "./desk.js";
var jt = 180 / Math.PI;
function $a(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * jt : 0;
}
function Hr(e, t) {
  let n = [0, 0, 0, Math.cos(t / jt / 2)];
  return n[e] = Math.sin(t / jt / 2), n;
}
function Va() {
  let e = (Ea.value?.ids ?? []).filter((u) => Yt.get(u)), t = e.map((u) => Yt.get(u));
  if (!t.length) return S("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, l = t.some((u) => u.locked), r = (u, s) => La(`${a}: ${u}`, { things: Object.fromEntries(e.map((p, c) => [p, s(t[c])])) }), o = t.map((u) => u.place?.position ?? (u.box ? Sa(u.box) : [0, 0, 0])), i = n.box ? [0, 1, 2].map((u) => n.box[1][u] - n.box[0][u]) : null;
  return X(Qt, { children: [
    S("header", { class: "panel-head", children: S("h2", { children: a }) }),
    i && X("p", { class: "crumbs", children: [
      i.map((u) => Xt(u, 2)).join(" × "),
      " m"
    ] }),
    X("div", { class: "scroll", children: [
      X("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        X("button", { "aria-pressed": t.every((u) => u.hidden), onClick: () => r(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          S(Ca, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        X("button", { "aria-pressed": l, onClick: () => r(l ? "unlock" : "lock", () => ({ locked: !l })), children: [
          S(Ca, { name: l ? "lock" : "unlock" }),
          l ? "Locked" : "Lock"
        ] })
      ] }),
      X(V, { title: "Place", note: "re-trace", children: [
        l && S("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        S(
          Z,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: l,
            value: [0, 1, 2].map((u) => W(o.map((s) => Math.round(s[u] * 1e4) / 1e4))),
            set: (u, s) => r("move", (p) => ({ place: { position: ae(p.place?.position ?? Sa(p.box), u, s) } }))
          }
        ),
        [0, 1, 2].map((u) => S(
          A,
          {
            label: `Turn ${"XYZ"[u]}`,
            quantity: "angle",
            step: 5,
            disabled: l,
            value: W(t.map((s) => Math.round($a(s.place?.rotation, u) * 10) / 10)),
            set: (s) => r("turn", (p) => ({ place: { rotation: Hr(u, s($a(p.place?.rotation, u))) } }))
          },
          u
        )),
        S(
          A,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: l,
            value: W(t.map((u) => u.place?.scale ?? 1)),
            set: (u) => r("scale", (s) => ({ place: { scale: Math.max(1e-3, u(s.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      S(V, { title: "Materials", children: S("ul", { class: "buttons", children: n.materials.map((u) => S("li", { children: S("button", { onClick: () => Pa("material", u), children: Ta.get(u)?.name ?? `material ${u}` }) }, u)) }) })
    ] })
  ] });
}
function Aa() {
  let e = Ea.value?.ids[0], t = Ta.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This material is gone." });
  let n = (s, p) => La(`${t.name}: ${s}`, { materials: { [e]: p } }), a = t.transmittance ? "transmittance" : "color", l = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], o = ((s) => 0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2])(l), i = (s) => l.map((p) => Math.max(0, Math.min(1, o > 1e-4 ? p / o * s : s))), u = (s, p) => t[p] != null && X(Qt, { children: [
    X("div", { class: "line slide", children: [
      S("span", { children: s }),
      S(Ce, { label: s, name: `${t.name}: ${s.toLowerCase()}`, value: t[p], text: Xt(t[p], 2), patch: (c) => ({ materials: { [e]: { [p]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    S(A, { label: "", name: `${s}, typed`, quantity: "share", step: 0.01, value: t[p], set: (c) => n(s.toLowerCase(), { [p]: Math.max(0, Math.min(1, c(t[p]))) }) })
  ] });
  return X(Qt, { children: [
    S("header", { class: "panel-head", children: S("h2", { children: t.name }) }),
    S("p", { class: "crumbs", children: t.kind }),
    X("div", { class: "scroll", children: [
      X(V, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        X("div", { class: "line slide", children: [
          S("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          S(Ce, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: o, text: Xt(o, 2), patch: (s) => ({ materials: { [e]: { [a]: i(Math.min(0.95, s)) } } }) })
        ] }),
        S(A, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(o * 1e3) / 1e3, set: (s) => n("reflectance", { [a]: i(Math.min(0.98, s(o))) }) }),
        X("label", { class: "line", children: [
          S("span", { children: "Colour" }),
          S("input", { type: "color", class: "pick", "aria-label": "Colour", value: Nr(l), onChange: (s) => n("colour", { [a]: Fr(s.currentTarget.value) }) })
        ] }),
        u("Roughness", "roughness"),
        u("Gloss", "specular")
      ] }),
      S(V, { title: "On", children: S("ul", { class: "buttons", children: Yt.all().filter(([, s]) => s.materials.includes(e)).slice(0, 40).map(([s, p]) => S("li", { children: S("button", { onClick: () => Pa("thing", s), children: p.name }) }, s)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as Ia, jsx as O, jsxs as Jt } from "./desk.js";
var Be = ["Scene", "Things", "Materials", "History"], pe = Wr("Scene");
function Gr() {
  let e = { Scene: ya, Things: wa, Materials: xa, History: Ma }[pe.value];
  return Jt(Ia, { children: [
    O("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), pe.value = Be[(Be.indexOf(pe.value) + a + Be.length) % Be.length], document.getElementById(`tab-${pe.value}`)?.focus());
    }, children: Be.map((n) => O("button", { id: `tab-${n}`, role: "tab", "aria-selected": pe.value === n, "aria-controls": "tab-panel", tabIndex: pe.value === n ? 0 : -1, onClick: () => pe.value = n, children: n }, n)) }),
    O("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${pe.value}`, tabIndex: 0, children: O(e, {}) })
  ] });
}
function Br() {
  let e = Or.value;
  return e ? Jt(Ia, { children: [
    Jt("nav", { class: "chooser", "aria-label": "Selection", children: [
      O("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => qa("previous"), children: O(Zt, { name: "back" }) }),
      O("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => qa("next"), children: O(Zt, { name: "forth" }) }),
      O("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      O("span", { class: "gap" }),
      O("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: Dr, children: O(Zt, { name: "close" }) })
    ] }),
    (e.kind === "lamp" || e.kind === "group") && O(pa, {}),
    e.kind === "thing" && O(Va, {}),
    e.kind === "material" && O(Aa, {}),
    e.kind === "meter" && O(Xn, {}),
    e.kind === "grid" && O(Yn, {})
  ] }) : O(Gr, {});
}

// src/later/legend.tsx
import { candles as Kr, display as Ur, Field as zr, show as _r, three as Xr, useRef as Yr } from "./desk.js";
import { jsx as Y, jsxs as gt } from "./desk.js";
var en = [1, 2, 5];
function jr(e, t, n) {
  let a = [];
  if (n === "linear") {
    let l = (t - e) / 5, r = 10 ** Math.floor(Math.log10(l)), o = r * (en.find((i) => i * r >= l) ?? 10);
    for (let i = Math.ceil(e / o) * o; i <= t * 1.0001; i += o) a.push(i);
    return a;
  }
  for (let l = Math.floor(Math.log10(e)); l <= Math.ceil(Math.log10(t)); l++)
    for (let r of en) {
      let o = r * 10 ** l;
      o >= e * 0.999 && o <= t * 1.001 && a.push(o);
    }
  return a.length > 10 ? a.filter((l) => Math.abs(Math.log10(l) % 1) < 1e-6) : a;
}
function Qr(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var le = (e, t) => {
  let n = { ...e, ...t };
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && _r({ false_color: n });
};
function Ra(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return en[a] * 10 ** ((n - a) / 3);
}
function Zr() {
  let e = Ur.value.false_color, t = Yr(null);
  if (!e) return null;
  let n = Kr.value === "fc", a = e.quantity === "illuminance", l = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", r = n ? a ? 1 / 10.7639 : 0.2919 : 1, o = e.colors, i = o?.length ? `linear-gradient(to top, ${o.join(", ")})` : void 0, u = (p) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: p, from: e[p] };
    },
    onPointerMove: (c) => {
      let g = t.current;
      g?.end === p && le(e, { [p]: Ra(g.from, Math.round((g.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let g = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      g && (c.preventDefault(), c.stopPropagation(), le(e, { [p]: Ra(e[p], g) }));
    }
  }), s = ({ end: p }) => gt("div", { class: "end", children: [
    Y(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": p === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[p],
        "aria-valuemin": 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${Xr(e[p] * r)} ${l}`,
        ...u(p)
      }
    ),
    Y(
      zr,
      {
        label: p === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[p] * r).toPrecision(3)),
        set: (c) => le(e, { [p]: c(e[p] * r) / r })
      }
    )
  ] });
  return gt("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    gt("header", { children: [
      Y(
        "button",
        {
          "aria-label": `Quantity: ${a ? "illuminance" : "luminance"}`,
          onClick: () => le(e, { quantity: a ? "luminance" : "illuminance" }),
          children: l
        }
      ),
      Y("button", { "aria-pressed": e.scale === "log", onClick: () => le(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      Y("button", { "aria-pressed": e.lines, onClick: () => le(e, { lines: !e.lines }), children: "lines" })
    ] }),
    Y(s, { end: "high" }),
    Y("div", { class: "scale", style: { background: i }, children: jr(e.low, e.high, e.scale).map((p) => Y("span", { style: { bottom: `${100 * Qr(p, e)}%` }, children: String(Number((p * r).toPrecision(2))) }, p)) }),
    Y(s, { end: "low" }),
    gt("footer", { children: [
      Y("button", { onClick: () => le(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      Y("button", { onClick: () => le(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      Y(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (p) => le(e, { palette: p.currentTarget.value }),
          children: e.palettes?.map((p) => Y("option", { children: p }, p)) ?? Y("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as an,
  act as Ka,
  ask as si,
  command as ui,
  copyText as ci,
  digits as pi,
  go as mi,
  hear as di,
  lamps as hi,
  say as ln,
  select as bi,
  send as vt,
  sheet as Ue,
  shown as gi,
  signal as ze,
  useEffect as kt,
  useRef as wt,
  walkNames as fi,
  whyNotTo as vi
} from "./desk.js";

// src/later/csv.ts
import { add as Fa, grids as Jr, maintenance as ei, meters as ti, scale as Na, scene as Ha } from "./desk.js";
var ni = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function ai() {
  let e = ei.peek(), t = [["scene", Ha.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of ti.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of Jr.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [l, r] of Object.entries(a)) t.push([l, r === null ? null : r * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), n.lux.forEach((l, r) => {
      let [o, i] = [r % n.columns, Math.floor(r / n.columns)], u = Fa(n.corner, Fa(Na(n.u, (o + 0.5) / n.columns), Na(n.v, (i + 0.5) / n.rows)));
      t.push([...u.map((s) => s.toFixed(3)), l === null ? null : l * e]);
    });
  }
  return t.map((n) => n.map(ni).join(",")).join(`\r
`) + `\r
`;
}
function tn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function Da() {
  let e = URL.createObjectURL(new Blob([ai()], { type: "text/csv" }));
  tn(`${Ha.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var Ga = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], ft = new Uint8Array(512), nn = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  ft[e] = ft[e + 255] = t, nn[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var Oa = (e, t) => e && t ? ft[nn[e] + nn[t]] : 0;
function li(e, t) {
  let n = [1];
  for (let l = 0; l < t; l++) {
    let r = new Array(n.length + 1).fill(0);
    n.forEach((o, i) => {
      r[i] ^= o, r[i + 1] ^= Oa(o, ft[l]);
    }), n = r;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let l = 0; l < e.length; l++) {
    let r = a[l];
    r && n.forEach((o, i) => a[l + i] ^= Oa(o, r));
  }
  return a.slice(e.length);
}
function oi(e, t) {
  let [n, a, l] = Ga[t - 1], r = [], o = (g, m) => {
    for (let y = m - 1; y >= 0; y--) r.push(g >> y & 1);
  };
  for (o(4, 4), o(e.length, 8), e.forEach((g) => o(g, 8)), o(0, Math.min(4, n * 8 - r.length)); r.length % 8; ) r.push(0);
  let i = [];
  for (let g = 0; g < r.length; g += 8) i.push(parseInt(r.slice(g, g + 8).join(""), 2));
  for (let g = 236; i.length < n; g ^= 253) i.push(g);
  let u = n / l, s = Array.from({ length: l }, (g, m) => i.slice(m * u, (m + 1) * u)), p = s.map((g) => li(g, a)), c = (g) => g[0].flatMap((m, y) => g.map((k) => k[y]));
  return [...c(s), ...c(p)];
}
var ri = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function ii(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function Wa(e) {
  let t = e.length, n = 0, a = 0;
  for (let l of [!1, !0])
    for (let r = 0; r < t; r++) {
      let o = Array.from({ length: t }, (s, p) => l ? e[p][r] : e[r][p]), i = 1;
      for (let s = 1; s <= t; s++)
        s < t && o[s] === o[s - 1] ? i++ : (i >= 5 && (n += i - 2), i = 1);
      let u = o.map(Number).join("");
      for (let s = 0; s + 11 <= t; s++) {
        let p = u.slice(s, s + 11);
        (p === "10111010000" || p === "00001011101") && (n += 40);
      }
    }
  for (let l = 0; l < t; l++)
    for (let r = 0; r < t; r++)
      e[l][r] && a++, r && l && e[l][r] === e[l - 1][r] && e[l][r] === e[l][r - 1] && e[l][r] === e[l - 1][r - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function Ba(e) {
  let t = [...new TextEncoder().encode(e)], n = Ga.findIndex(([m]) => t.length + 2 <= m) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, l = Array.from({ length: a }, () => new Array(a).fill(!1)), r = Array.from({ length: a }, () => new Array(a).fill(!1)), o = (m, y, k) => {
    m < 0 || y < 0 || m >= a || y >= a || (l[y][m] = k, r[y][m] = !0);
  };
  for (let m = 0; m < a; m++)
    o(m, 6, m % 2 === 0), o(6, m, m % 2 === 0);
  for (let [m, y] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let k = -4; k <= 4; k++)
      for (let R = -4; R <= 4; R++) {
        let B = Math.max(Math.abs(R), Math.abs(k));
        o(m + R, y + k, B !== 2 && B !== 4);
      }
  if (n > 1) {
    let m = a - 7;
    for (let y = -2; y <= 2; y++) for (let k = -2; k <= 2; k++) o(m + k, m + y, Math.max(Math.abs(k), Math.abs(y)) !== 1);
  }
  let i = (m) => {
    let y = ii(m);
    for (let k = 0; k < 15; k++) {
      let R = (y >> k & 1) === 1, B = k < 6 ? k : k < 8 ? k + 1 : a - 15 + k;
      o(8, B, R), o(k < 8 ? a - 1 - k : k < 9 ? 7 : 14 - k, 8, R);
    }
    o(8, a - 8, !0);
  };
  i(0);
  let u = oi(t, n), s = 0;
  for (let m = a - 1; m > 0; m -= 2) {
    m === 6 && (m = 5);
    for (let y = 0; y < a; y++)
      for (let k of [m, m - 1]) {
        let B = (m + 1 & 2) === 0 ? a - 1 - y : y;
        r[B][k] || (l[B][k] = s < u.length * 8 && (u[s >> 3] >> 7 - (s & 7) & 1) === 1, s++);
      }
  }
  let p = (m) => (i(m), l.map((y, k) => y.map((R, B) => R !== (!r[k][B] && ri[m](B, k))))), c = p(0), g = Wa(c);
  for (let m = 1; m < 8; m++) {
    let y = p(m), k = Wa(y);
    k < g && ([c, g] = [y, k]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as Ti, jsx as h, jsxs as $ } from "./desk.js";
function _e({ title: e, wide: t, children: n }) {
  let a = wt(null);
  kt(() => {
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
var yi = [
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
function ki() {
  let e = [...new Set(an().map((t) => t.group))];
  return h(_e, { title: "All keys", wide: !0, children: $("div", { class: "help", children: [
    $("table", { children: [
      h("caption", { class: "spoken", children: "By hand" }),
      h("thead", { children: $("tr", { children: [
        h("th", { scope: "col", children: "What" }),
        h("th", { scope: "col", children: "Mouse" }),
        h("th", { scope: "col", children: "Keys, in the view" }),
        h("th", { scope: "col", children: "Fingers" })
      ] }) }),
      h("tbody", { children: yi.map(([t, n, a, l]) => $("tr", { children: [
        h("th", { scope: "row", children: t }),
        h("td", { children: n }),
        h("td", { children: a.replace("walking keys", fi.value) }),
        h("td", { children: l })
      ] }, t)) })
    ] }),
    $("div", { class: "columns", children: [
      e.map((t) => $("section", { children: [
        h("h3", { children: t }),
        h("dl", { children: an().filter((n) => n.group === t && n.keys).map((n) => $(Ti, { children: [
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
var yt = ze(""), Ke = ze(0);
function wi() {
  let e = yt.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((l) => a.toLowerCase().includes(l)), n = an().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: vi(a.id), run: () => Ka(a.id) }));
  for (let { name: a, camera: l } of Je())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => mi(l, a) });
  if (e.length)
    for (let [a, l] of hi.all()) {
      if (n.length > 60) break;
      t(l.name) && n.push({ label: l.name, note: "lamp", why: null, run: () => bi("lamp", a) });
    }
  return n.slice(0, 60);
}
function xi() {
  let e = wi(), t = Math.min(Ke.value, e.length - 1);
  kt(() => {
    yt.value = "", Ke.value = 0;
  }, []), kt(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (Ue.value = null, a.why ? ln(a.why, "warn") : setTimeout(a.run, 0));
  };
  return $(_e, { title: "Command palette", children: [
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
        value: yt.value,
        onInput: (a) => {
          yt.value = a.currentTarget.value, Ke.value = 0;
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
var Ua = ze([]);
di("links", (e) => Ua.value = e.links);
function Mi({ text: e }) {
  let t = Ba(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((l, r) => l.map((o, i) => o ? `M${i + 4} ${r + 4}h1v1h-1z` : "").join("")).join("");
  return $("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    h("rect", { width: n, height: n, fill: "#fff" }),
    h("path", { d: a, fill: "#000" })
  ] });
}
function Ci() {
  let e = ze(null), t = wt(e).current;
  return kt(() => {
    vt({ do: "links", what: "list" });
  }, []), $(_e, { title: "Share by link", children: [
    h("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    h("ul", { class: "links", children: Ua.value.map((n) => $("li", { children: [
      h("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      h("code", { children: n.address }),
      $("span", { class: "buttons", children: [
        h("button", { onClick: () => {
          ci(n.address);
        }, children: "Copy" }),
        h("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        h("button", { onClick: () => vt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && h(Mi, { text: n.address })
    ] }, n.id)) }),
    $("footer", { children: [
      h("button", { onClick: () => vt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      h("button", { onClick: () => vt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function Si() {
  let e = wt(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    ui({ do: "save", name: n }), Ue.value = null, ln(`Saving the version “${n}”.`);
  };
  return $(_e, { title: "Save a version", children: [
    h("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    $("label", { class: "line", children: [
      h("span", { children: "Name" }),
      h("span", { class: "field", children: h("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    h("footer", { children: h("button", { onClick: t, children: "Save" }) })
  ] });
}
var oe = ze(null);
function $i() {
  let e = gi.value?.head, t = wt(null), n = (l) => t.current?.querySelector(`[name=${l}]`)?.value ?? "", a = () => {
    oe.value = 0;
    let [l, r] = [Number(n("width")), Number(n("height"))];
    si("picture", { format: n("format"), width: l, height: r, batches: Number(n("batches")) }, (o) => {
      o.url ? (oe.value = null, tn(o.name, o.url), Ue.value = null) : oe.value = o.progress ?? 0;
    }, (o) => {
      oe.value = null, ln(o, "warn");
    });
  };
  return $(_e, { title: "Save the picture", children: [
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
    oe.value !== null && h("progress", { max: 1, value: oe.value, "aria-label": "Rendering" }),
    $("footer", { children: [
      h("button", { onClick: () => Ka("command"), children: "Copy the command" }),
      h("button", { disabled: oe.value !== null, onClick: a, children: oe.value === null ? "Render and save" : `${pi(oe.value * 100)} %` })
    ] })
  ] });
}
function Li() {
  switch (Ue.value) {
    case "help":
      return h(ki, {});
    case "palette":
      return h(xi, {});
    case "share":
      return h(Ci, {});
    case "save":
      return h(Si, {});
    case "picture":
      return h($i, {});
    default:
      return null;
  }
}

// src/later/strip.tsx
import {
  act as za,
  command as Za,
  digits as on,
  fade as xt,
  Field as Pi,
  grids as _a,
  Icon as Ae,
  looks as Xa,
  luxText as Ve,
  maintenance as Ei,
  meters as Ya,
  select as ja,
  selection as Mt,
  signal as Vi,
  status as rn,
  storeLook as Ai
} from "./desk.js";
import { Fragment as Ni, jsx as M, jsxs as F } from "./desk.js";
var sn = Vi("looks");
function qi() {
  return F("section", { class: "looks", "aria-label": "Looks", children: [
    F("header", { children: [
      M("h2", { children: "Looks" }),
      M("button", { class: "tab", onClick: () => sn.value = "meters", children: "Meters" }),
      M("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: Ai, children: M(Ae, { name: "plus" }) }),
      M("span", { class: "gap" }),
      F("label", { class: "tint", children: [
        "Fade",
        M(Pi, { label: "Cross-fade", quantity: "seconds", value: xt.value, step: 0.5, set: (e) => xt.value = Math.max(0, e(xt.value)) })
      ] })
    ] }),
    F("ul", { children: [
      Xa.all().map(([e, t], n) => F("li", { class: "look", children: [
        F("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Za({ do: "look", id: e, what: "recall", seconds: xt.peek() }), children: [
          t.picture && M("img", { src: t.picture, alt: "" }),
          M("span", { children: t.name })
        ] }),
        M(Ii, { id: e, name: t.name })
      ] }, e)),
      !Xa.ids.value.length && M("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function Ii({ id: e, name: t }) {
  let n = `look-${e}`, a = (i) => {
    let u = i.getBoundingClientRect(), s = document.getElementById(n);
    s?.style.setProperty("left", `${Math.min(u.left, innerWidth - 296)}px`), s?.style.setProperty("bottom", `${innerHeight - u.top + 4}px`), s?.style.setProperty("top", "auto");
  }, l = { popovertarget: n }, r = () => document.getElementById(n)?.hidePopover(), o = (i, u = {}) => {
    r(), Za({ do: "look", id: e, what: i, ...u });
  };
  return F(Ni, { children: [
    M("button", { class: "icon more", ...l, "aria-label": `More of ${t}`, onPointerDown: (i) => a(i.currentTarget), onFocus: (i) => a(i.currentTarget), children: M(Ae, { name: "more" }) }),
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
var Qa = () => rn.value?.stage === "moving" || rn.value?.stage === "refining" || rn.value?.stage === "loading";
function Ri() {
  let e = Ei.value;
  return F("section", { class: "readings", "aria-label": "Meters and grids", children: [
    F("header", { children: [
      M("h2", { children: "Meters" }),
      M("button", { class: "tab", onClick: () => sn.value = "looks", children: "Looks" }),
      M("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => za("meter-tool"), children: M(Ae, { name: "meter" }) }),
      M("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => za("grid"), children: M(Ae, { name: "grid" }) }),
      M("button", { onClick: Da, title: "Save all figures as CSV", children: "CSV" }),
      M("span", { class: "gap" }),
      M("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${on(e, 2)} maintained` })
    ] }),
    F("ul", { children: [
      Ya.all().map(([t, n]) => {
        let a = n.lux, l = !a || a[1] > 0.02 * a[0] || Qa();
        return M("li", { children: F("button", { class: "reading", "aria-pressed": Mt.value?.kind === "meter" && Mt.value.ids.includes(t), onClick: () => ja("meter", t), children: [
          F("span", { class: "tint", children: [
            M(Ae, { name: "meter" }),
            n.name
          ] }),
          M("strong", { class: l ? "unsettled" : "", children: a ? Ve(a[0] * e) : "…" }),
          F("small", { children: [
            a ? `±${Ve(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind
          ] })
        ] }) }, `m${t}`);
      }),
      _a.all().map(([t, n]) => {
        let a = n.target, l = a && n.mean !== null && n.uniformity !== null && n.mean * e >= a.lux && n.uniformity >= a.uniformity;
        return M("li", { children: F("button", { class: "reading", "aria-pressed": Mt.value?.kind === "grid" && Mt.value.ids.includes(t), onClick: () => ja("grid", t), children: [
          F("span", { class: "tint", children: [
            M(Ae, { name: "grid" }),
            n.name,
            " ",
            a && n.mean !== null && M("b", { class: l ? "met" : "missed", children: l ? "✓" : "✗" })
          ] }),
          M("strong", { class: Qa() ? "unsettled" : "", children: n.mean === null ? "…" : `Ē ${Ve(n.mean * e)}` }),
          F("small", { children: [
            "U₀ ",
            n.uniformity === null ? "…" : on(n.uniformity, 2),
            " · ",
            n.min === null ? "…" : Ve(n.min * e, !1),
            " to",
            " ",
            n.max === null ? "…" : Ve(n.max * e, !1),
            a ? ` · wants ${Ve(a.lux)}, U₀ ${on(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !Ya.ids.value.length && !_a.ids.value.length && M("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Fi() {
  return F("div", { class: "strip-parts", "data-tab": sn.value, children: [
    M(qi, {}),
    M(Ri, {})
  ] });
}

// src/later/menus.tsx
import {
  digits as Hi,
  display as Di,
  Field as Ja,
  go as Oi,
  houseLights as un,
  Item as ke,
  Range as Wi,
  show as cn,
  theme as el,
  walking as Gi
} from "./desk.js";
import { Fragment as pn, jsx as P, jsxs as me } from "./desk.js";
function Bi() {
  let e = Je();
  return me(pn, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((t) => P(ke, { id: t }, t)),
    P("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((t) => P(ke, { id: `preset-${t}` }, t)),
    P("hr", {}),
    e.length > 0 && P("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    e.map(({ name: t, camera: n }, a) => P("button", { class: "item", onClick: () => Oi(n, t), children: P("span", { children: t }) }, a)),
    e.length > 0 && P("hr", {}),
    P(ke, { id: "walking", label: Gi.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    P(ke, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((t) => P(ke, { id: `hands-${t}` }, t))
  ] });
}
var Ki = ["linear", "reinhard", "filmic"];
function Ui() {
  let e = Di.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return me(pn, { children: [
    me("fieldset", { children: [
      P("legend", { children: "Tone curve" }),
      P("div", { class: "segments", children: Ki.map((n) => P("button", { "aria-pressed": e.tone === n, onClick: () => cn({ tone: n }), children: n }, n)) })
    ] }),
    me("fieldset", { children: [
      P("legend", { children: "White balance" }),
      me("label", { class: "line", children: [
        P("span", { children: "White" }),
        P(Ja, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => cn({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      me("label", { class: "line", children: [
        P("span", { children: "Tint" }),
        P(Ja, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => cn({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    P("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => P(ke, { id: n }, n))
  ] });
}
function zi() {
  return me(pn, { children: [
    me("label", { class: "line", children: [
      P("span", { children: "House lights" }),
      P(Wi, { label: "House lights", value: un.value, text: `${Hi(un.value * 100)} %`, on: (e) => un.value = Math.max(0.3, e) })
    ] }),
    P("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => P("button", { "aria-pressed": el.value === e, onClick: () => el.value = e, children: e }, e)) }),
    P("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => P(ke, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as Ct, cut as _i, digits as tl, edit as nl, go as Xi, Icon as Xe, Range as Yi, setCut as ji, storeView as Qi, viewName as Zi, views as Ji } from "./desk.js";
import { jsx as z, jsxs as mn } from "./desk.js";
function es() {
  let e = Ji.all();
  return mn("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    z("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => Ct("home"), children: z(Xe, { name: "home" }) }),
    z("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => Ct("frame"), children: z(Xe, { name: "frame" }) }),
    z("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => Ct("back"), children: z(Xe, { name: "back" }) }),
    z("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => Ct("forth"), children: z(Xe, { name: "forth" }) }),
    z("span", { class: "divide" }),
    e.map(([t, n], a) => mn(
      "button",
      {
        class: "saved-view",
        "aria-pressed": Zi.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click to rename, Delete to remove`,
        onClick: () => Xi(n, n.name ?? "view"),
        onDblClick: () => {
          let l = prompt("Name of the view", n.name ?? "");
          l && nl(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (l) => {
          l.key === "Delete" && (l.stopPropagation(), nl(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          z("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    z("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: Qi, children: z(Xe, { name: "plus" }) })
  ] });
}
function ts() {
  let e = _i.value;
  if (!e) return null;
  let t = e.height === null ? `${tl(e.value, 2)} m` : `at ${tl(e.height, 2)} m`;
  return mn("label", { class: "cut", "data-scroll": !0, children: [
    z("span", { children: "Cut" }),
    z(
      Yi,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => ji(n * e.most)
      }
    ),
    z("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as ns, useRef as as } from "./desk.js";
import { jsx as al } from "./desk.js";
function ls() {
  let e = as(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let l = n.type === "pointerup" || n.type === "pointercancel";
    if (!l && !a.hasPointerCapture(n.pointerId)) return;
    let r = a.getBoundingClientRect(), o = (s) => Math.max(-1, Math.min(1, s)), i = l ? 0 : o((n.clientX - r.left) / (r.width / 2) - 1), u = l ? 0 : o(1 - (n.clientY - r.top) / (r.height / 2));
    e.current?.style.setProperty("transform", `translate(${i * 28}px, ${-u * 28}px)`), ns(u, i);
  };
  return al("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: al("span", { ref: e }) });
}

// src/later/what.tsx
import {
  addMeter as os,
  aim as rs,
  chosenLamps as ll,
  closeWhat as ol,
  digits as is,
  hovered as rl,
  Icon as ss,
  luxText as de,
  nameOf as us,
  select as cs,
  useEffect as ps,
  useRef as ms,
  viewSize as ds,
  what as hs
} from "./desk.js";
import { jsx as G, jsxs as J } from "./desk.js";
var we = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], bs = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function gs() {
  let e = hs.value, t = ms(null);
  if (ps(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = ds.value, l = [...e.lamps].sort((c, g) => we(g) - we(c)), r = l.reduce((c, g) => c + we(g), 0) || 1, o = l.slice(0, 9), i = r - o.reduce((c, g) => c + we(g), 0), u = Math.max(8, Math.min(e.x + 12, n - 332)), s = Math.max(8, Math.min(e.y + 12, a - 120 - 28 * Math.min(l.length, 10))), p = e.lux ? `${de(e.lux[0])} ±${de(e.lux[1], !1)}` : "Measuring…";
  return J(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${u}px`, top: `${s}px` },
      onKeyDown: (c) => {
        c.key === "Escape" && (c.stopPropagation(), ol(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        J("header", { children: [
          G("strong", { class: e.done ? "" : "unsettled", children: p }),
          G("span", { class: "quiet", children: "what lights this" }),
          G("button", { class: "icon", "aria-label": "Close", onClick: ol, children: G(ss, { name: "close" }) })
        ] }),
        J("ol", { children: [
          o.map((c) => G(
            "li",
            {
              onPointerEnter: () => rl.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => rl.value = null,
              children: J("button", { class: "row", onClick: () => cs("lamp", c.id), children: [
                G("span", { class: "name", children: us("lamp", c.id) }),
                J("span", { class: "figure", children: [
                  is(100 * we(c) / r, we(c) / r < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                J("span", { class: "figure lux", children: [
                  de(we(c)),
                  " ±",
                  de(bs(c), !1)
                ] }),
                J("span", { class: "bar", "aria-hidden": "true", children: [
                  G("i", { class: "direct", style: { width: `${100 * c.direct[0] / r}%` } }),
                  G("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / r}%` } }),
                  G("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / r}%` } })
                ] }),
                J("span", { class: "spoken", children: [
                  "direct ",
                  de(c.direct[0]),
                  ", indirect ",
                  de(c.indirect[0]),
                  ", caustic",
                  " ",
                  de(c.caustic[0])
                ] })
              ] })
            },
            c.id
          )),
          l.length > o.length && J("li", { class: "quiet", children: [
            "and ",
            l.length - o.length,
            " others, ",
            de(i),
            " together"
          ] }),
          !l.length && G("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        J("footer", { children: [
          G("span", { class: "key direct", children: "direct" }),
          G("span", { class: "key indirect", children: "indirect" }),
          G("span", { class: "key caustic", children: "caustic" }),
          G("span", { class: "gap" }),
          ll.value.length > 0 && G("button", { onClick: () => rs(ll.peek(), e.hit.point), children: "Aim here" }),
          G("button", { onClick: () => os(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Jl as Compare,
  ts as CutBar,
  Ao as Gizmo,
  Br as Inspector,
  Zr as Legend,
  zi as PageItems,
  Ui as SeeingItems,
  Li as Sheets,
  Fi as Strip,
  Bi as ViewItems,
  es as ViewStrip,
  ls as WalkPad,
  gs as What
};
