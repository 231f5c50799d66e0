// src/later/actions.ts
import {
  addMeter as Rt,
  adding as qt,
  aim as Wt,
  ask as Dt,
  back as Gt,
  candles as Ge,
  chosenLamps as W,
  clearSolo as Nt,
  command as Ne,
  compareHeld as Ot,
  copyAlong as Bt,
  copyText as Ut,
  deselect as Kt,
  each as Ce,
  edit as Le,
  exposeBy as Oe,
  falseColor as zt,
  fine as Be,
  forth as _t,
  frameSelection as Xt,
  go as Yt,
  goHome as Jt,
  goInside as Zt,
  goPreset as jt,
  handles as Ue,
  hands as Qt,
  here as en,
  highlight as tn,
  history as Ke,
  lampMarks as ze,
  lamps as ue,
  listing as _e,
  lookOnly as Xe,
  panels as Ye,
  PRESETS as nn,
  register as on,
  removeLamps as an,
  say as se,
  scene as ln,
  selection as tt,
  send as rn,
  sheet as oe,
  show as sn,
  soloSelection as un,
  spot as ae,
  startTool as X,
  stepSelection as Je,
  storeLook as cn,
  storeView as pn,
  theme as Ze,
  things as je,
  titleOf as nt,
  toggleFalse as dn,
  toggleWipe as mn,
  travel as Qe,
  views as hn,
  walking as Se,
  whyNot as T
} from "./desk.js";
var q = () => T() ?? (W.value.length ? null : "Select a lamp first.");
function gn() {
  let e = W.peek(), t = !e.some((n) => ue.get(n)?.on);
  Le(`${nt(e)} ${t ? "on" : "off"}`, { lamps: Ce(e, { on: t }) });
}
function fn() {
  let e = W.peek(), t = !e.every((n) => ue.get(n)?.parked);
  Le(`${t ? "Park" : "Unpark"} ${nt(e)}`, { lamps: Ce(e, { parked: t }) });
}
function et(e) {
  let t = tt.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : je.ids.peek().filter((a) => je.get(a)?.hidden);
  if (!n.length) return se(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Le(e ? "Hide things" : "Show hidden things", { things: Ce(n, { hidden: e }) });
}
function bn() {
  let e = W.peek()[0], t = ue.get(e)?.place, n = en();
  if (!t?.position || !t.direction || !n) return se("Select a lamp that has a direction.", "warn");
  let { position: a, direction: l } = t;
  Yt({ ...n, eye: a, target: [a[0] + l[0], a[1] + l[1], a[2] + l[2]], height: null, near: null }, "from the lamp");
}
function vn() {
  Dt("command", {}, (e) => {
    Ut(e.text);
  });
}
var yn = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], kn = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, wn = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: Xt },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: Jt },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: Zt },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: Gt },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: _t },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: pn, why: T },
  ...nn.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: kn[e],
    keys: `Shift+${t + 1}`,
    run: () => jt(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      Se.value = Se.peek() === "walk" ? "fly" : "walk", se(Se.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: bn, why: q },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => Je(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => Je(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => X("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => tt.value = { kind: "lamp", ids: ue.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: Kt },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: gn, why: q },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: un, why: () => W.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: Nt },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => tn(!0), why: q },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: fn, why: q },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => X("aim"), why: q },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => ae.peek() && Wt(W.peek(), ae.peek().point), why: q },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => Ue.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => Ue.value = "turn" },
  ...yn.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: T,
    run: () => {
      qt.value = e, X("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => Bt(W.peek(), 1, [0.5, 0, 0]), why: q },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => an(W.peek()), why: q },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => et(!0), why: T },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => et(!1), why: T },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => Ne({ do: "undo" }), why: () => T() ?? (Ke.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => Ne({ do: "redo" }), why: () => T() ?? (Ke.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => oe.value = "save", why: T },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => oe.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: vn },
  { id: "share", group: "Work", label: "Share by link", run: () => oe.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: dn },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = zt();
      sn({ false_color: { ...e, quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => Oe(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => Oe(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => rn({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => Ot(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: mn },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: T, run: () => ae.peek() ? Rt(ae.peek().point, ae.peek().normal) : X("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => X("meter"), why: T },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => X("grid"), why: T },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => Ge.value = Ge.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: cn, why: T },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => se("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => Ye.value = !Ye.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => _e.value = _e.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => Qe.value = Qe.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => ze.value = !ze.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => Be.value = !Be.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => Ze.value = Ze.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => Xe.value = !Xe.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => Qt.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => oe.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => oe.value = "palette" }
];
on(wn);
function ot() {
  return [...(ln.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...hn.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as xn, comparing as Sn, digits as Cn, fitted as Ln, useEffect as $n, useRef as Mn, viewSize as Pn, wipeAt as $e } from "./desk.js";
import { Fragment as En, jsx as Me, jsxs as Tn } from "./desk.js";
function Vn() {
  let e = Sn.value, t = xn.value, n = Mn(null);
  if ($n(() => {
    let g = n.current;
    !g || !t || (g.width = t.picture.width, g.height = t.picture.height, g.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = Pn.value, l = $e.value, s = Ln(t.picture.width, t.picture.height), m = Math.max(0, Math.min(1, (l * a - s.x) / (t.picture.width * s.scale))), h = (g) => {
    let d = g.currentTarget;
    if (g.stopPropagation(), g.type === "pointerdown") d.setPointerCapture(g.pointerId);
    else if (d.hasPointerCapture(g.pointerId)) {
      let c = d.parentElement.getBoundingClientRect();
      $e.value = Math.max(0, Math.min(1, (g.clientX - c.left) / c.width));
    }
  }, y = (g) => {
    let d = { ArrowLeft: -0.02, ArrowRight: 0.02 }[g.key];
    d && (g.stopPropagation(), g.preventDefault(), $e.value = Math.max(0, Math.min(1, l + d)));
  };
  return Tn(En, { children: [
    Me(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * m}% 0 0)` : "none" }
      }
    ),
    Me("span", { class: "tag left", children: "before" }),
    e === "wipe" && Me(
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
        "aria-valuetext": `${Cn(l * 100)} % before`,
        style: { left: `${100 * l}%` },
        onPointerDown: h,
        onPointerMove: h,
        onKeyDown: y
      }
    )
  ] });
}

// src/later/handles.tsx
import {
  chosenLamps as pt,
  computed as dt,
  editor as Nn,
  effect as On,
  fitted as Bn,
  Gesture as Un,
  handles as Kn,
  lamps as de,
  lookOnly as zn,
  pinhole as _n,
  placed as Xn,
  positionOf as ut,
  positions as Yn,
  role as Jn,
  selection as ct,
  shown as Zn,
  titleOf as jn,
  tool as Qn,
  useEffect as eo,
  useRef as to,
  viewSize as no
} from "./desk.js";

// src/later/gizmo.ts
import { project as at, ray as An } from "./desk.js";
import { across as Fn, add as F, cross as Hn, distance as In, dot as D, length as Rn, normal as ce, scale as H, sub as Y, turn as qn } from "./desk.js";
var Wn = "http://www.w3.org/2000/svg", Pe = 84, U = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], pe = ["x", "y", "z"], lt = 0.1, Dn = 5 * Math.PI / 180, rt = 48;
function st(e, t) {
  let n = (o, r, i) => {
    let u = document.createElementNS(Wn, o);
    return u.setAttribute("class", i), r.append(u), u;
  }, a = (o, r, i) => {
    let u = n("g", e, `handle ${o} ${pe[r] ?? ""}`);
    return u.setAttribute("data-handle", i), { group: u, hit: n("path", u, "hit"), seen: n("path", u, "seen") };
  }, l = n("path", e, "aim-line"), s = U.map((o, r) => a("ring", r, `ring-${pe[r]}`)), m = U.map((o, r) => a("plane", r, `plane-${pe[r]}`)), h = U.map((o, r) => a("arrow", r, `move-${pe[r]}`)), y = a("centre", -1, "move-view"), g = a("aim", -1, "aim"), d = n("text", e, "handle-text"), c = (o, r) => {
    let [i, u, b] = at(o.hole, r);
    return b < 0.02 && !o.hole.parallel ? null : [o.fit.x + i * o.fit.scale, o.fit.y + u * o.fit.scale];
  }, L = (o, r) => {
    let i = at(o.hole, r)[2];
    return Pe / o.fit.scale * o.hole.pixel * (o.hole.parallel ? 1 : Math.max(i, 0.02));
  }, _ = (o, r, i = !1) => {
    let u = r.filter((f) => f !== null), b = u.length < r.length || u.length < 2 ? "" : `M${u.map((f) => `${f[0].toFixed(1)} ${f[1].toFixed(1)}`).join("L")}${i ? "Z" : ""}`;
    o.setAttribute("d", b);
  }, ve = (o, r, i) => {
    o.setAttribute("d", r ? `M${r[0] - i} ${r[1]}a${i} ${i} 0 1 0 ${2 * i} 0a${i} ${i} 0 1 0 ${-2 * i} 0` : "");
  }, ye = (o, r) => o.forEach((i) => i.group.classList.toggle("gone", !r));
  function Ht(o, r) {
    let i = o.position, u = c(r, i), b = L(r, i), f = o.mode === "move";
    ye([...h, ...m, y], f && u !== null), ye(s, !f && u !== null && o.direction !== null);
    let M = o.aim ?? (o.direction ? F(i, H(o.direction, 3 * b)) : null);
    if (ye([g], M !== null && u !== null), !u) {
      l.setAttribute("d", "");
      return;
    }
    U.forEach(($, S) => {
      let w = c(r, F(i, H($, b))), O = w ? Math.hypot(w[0] - u[0], w[1] - u[1]) < 12 : !0;
      if (h[S].group.classList.toggle("gone", !f || O), w && f) {
        let [B, te] = [(w[0] - u[0]) / Pe, (w[1] - u[1]) / Pe], ie = Math.hypot(B, te) || 1, [R, ne] = [B / ie, te / ie], xe = [u[0] + 14 * R, u[1] + 14 * ne];
        _(h[S].hit, [xe, w]), h[S].seen.setAttribute("d", `M${xe[0].toFixed(1)} ${xe[1].toFixed(1)}L${w[0].toFixed(1)} ${w[1].toFixed(1)}M${(w[0] - 9 * R - 4.5 * ne).toFixed(1)} ${(w[1] - 9 * ne + 4.5 * R).toFixed(1)}L${w[0].toFixed(1)} ${w[1].toFixed(1)}L${(w[0] - 9 * R + 4.5 * ne).toFixed(1)} ${(w[1] - 9 * ne - 4.5 * R).toFixed(1)}`);
      }
      let [Q, ee] = [U[(S + 1) % 3], U[(S + 2) % 3]], E = Math.abs(D($, r.hole.parallel ? r.hole.forward : ce(Y(i, r.hole.eye)))) < 0.15;
      m[S].group.classList.toggle("gone", !f || E);
      let re = (B, te) => c(r, F(i, F(H(Q, B * b), H(ee, te * b)))), De = [re(0.3, 0.3), re(0.5, 0.3), re(0.5, 0.5), re(0.3, 0.5)];
      if (_(m[S].hit, De, !0), _(m[S].seen, De, !0), !f) {
        let B = Array.from({ length: rt + 1 }, (te, ie) => {
          let R = 2 * Math.PI * ie / rt;
          return c(r, F(i, F(H(Q, Math.cos(R) * b), H(ee, Math.sin(R) * b))));
        });
        _(s[S].hit, B), _(s[S].seen, B);
      }
    }), ve(y.hit, u, 13), ve(y.seen, u, 7);
    let k = M && c(r, M);
    _(l, [u, k]), ve(g.hit, k, 16), g.seen.setAttribute("d", k ? `M${k[0] - 8} ${k[1]}h16M${k[0]} ${k[1] - 8}v16M${k[0] - 5} ${k[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let It = t.effect(() => {
    let o = t.target.value, r = t.view.value;
    e.classList.toggle("empty", !o || !r), o && r && Ht(o, r);
  }), Re = (o, r, i) => An(o.hole, (r.clientX - i.left - o.fit.x) / o.fit.scale, (r.clientY - i.top - o.fit.y) / o.fit.scale);
  function j(o, r, i) {
    o.addEventListener("pointerdown", (u) => {
      if (u.button !== 0) return;
      u.preventDefault(), u.stopPropagation();
      let b = t.view.peek();
      if (!b || !t.target.peek()) return;
      let f = e.getBoundingClientRect(), M = i(b), k = t.hold(r), $ = Re(b, u, f);
      M($, !1, { ...k, move: () => {
      }, turn: () => {
      } }), o.setPointerCapture(u.pointerId), o.classList.add("held");
      let S = (E) => {
        d.textContent = M(Re(b, E, f), E.ctrlKey || E.metaKey, k), d.setAttribute("x", String(E.clientX - f.left + 16)), d.setAttribute("y", String(E.clientY - f.top - 12));
      }, w = (E) => {
        o.removeEventListener("pointermove", S), o.removeEventListener("pointerup", O), o.removeEventListener("pointercancel", Q), removeEventListener("keydown", ee, !0), o.classList.remove("held"), d.textContent = "", E ? k.end() : k.cancel();
      }, O = () => w(!0), Q = () => w(!1), ee = (E) => {
        E.key === "Escape" && (E.stopPropagation(), w(!1));
      };
      o.addEventListener("pointermove", S), o.addEventListener("pointerup", O), o.addEventListener("pointercancel", Q), addEventListener("keydown", ee, !0);
    });
  }
  let ke = (o, r, i) => i ? Math.round(o / r) * r : o, we = (o) => o.map((r) => r.toFixed(2)).join("  ") + " m";
  U.forEach((o, r) => {
    j(h[r].group, "move", () => {
      let i = t.target.peek().position, u = null;
      return (b, f, M) => {
        let k = Gn(i, o, b);
        u ??= k;
        let $ = H(o, ke(k - u, lt, f));
        return M.move($), we($);
      };
    }), j(m[r].group, "move", () => qe(o)), j(s[r].group, "turn", () => {
      let i = t.target.peek(), u = i.direction, b = { at: null };
      return (f, M, k) => {
        let $ = it(i.position, o, f), S = $ && ce(Y($, i.position), Fn(o));
        if (!S) return "";
        b.at ??= S;
        let w = Math.atan2(D(o, Hn(b.at, S)), D(b.at, S)), O = ke(w, Dn, M);
        return k.turn(ce(qn(u, o, O)), null), `${(O * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), j(y.group, "move", (o) => qe(o.hole.forward)), j(g.group, "aim", (o) => {
    let r = t.target.peek(), i = r.aim ?? F(r.position, H(r.direction, 3 * L(o, r.position))), u = We(i, o.hole.forward);
    return (b, f, M) => {
      let k = u(b, f), $ = F(i, k);
      return In($, r.position) > 1e-3 && M.turn(ce(Y($, r.position)), $), we($);
    };
  });
  function qe(o) {
    let r = We(t.target.peek().position, o);
    return (i, u, b) => {
      let f = r(i, u);
      return b.move(f), we(f);
    };
  }
  function We(o, r) {
    let i = null;
    return (u, b) => {
      let f = it(o, r, u);
      return f ? (i ??= f, Y(f, i).map((M) => ke(M, lt, b))) : [0, 0, 0];
    };
  }
  return { stop: It };
}
function Gn(e, t, n) {
  let a = Y(e, n.origin), l = D(t, n.direction), s = 1 - l * l;
  return s < 1e-6 ? 0 : (l * D(n.direction, a) - D(t, a)) / s;
}
function it(e, t, n) {
  let a = D(t, n.direction);
  if (Math.abs(a) < 1e-4 * Rn(t)) return null;
  let l = D(Y(e, n.origin), t) / a;
  return l < 0 || l > 1e3 ? null : F(n.origin, H(n.direction, l));
}

// src/later/handles.tsx
import { jsx as so } from "./desk.js";
var oo = dt(() => {
  if (ct.value?.kind !== "lamp" && ct.value?.kind !== "group" || zn.value || Jn.value === "watch" || !Nn.value.you || Qn.value === "aim") return null;
  let e = pt.value.filter((n) => ut(de.get(n)));
  if (!e.length) return null;
  let t = de.get(e[e.length - 1]);
  return {
    position: ut(t),
    direction: t.place?.direction ?? null,
    aim: t.place?.aim ?? null,
    mode: Kn.value
  };
}), ao = dt(() => {
  let e = Zn.value;
  if (no.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: _n(e.camera, t, n), fit: Bn(t, n) };
}), lo = () => pt.peek().filter((e) => de.entry(e)), ro = {
  effect: On,
  target: oo,
  view: ao,
  hold(e) {
    let t = lo(), n = e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn", a = new Un(`${n} ${jn(t)}`), l = Yn(t);
    return {
      move: (s) => a.set(Xn(t, s, l)),
      turn: (s, m) => {
        let h = Object.fromEntries(
          t.filter((y) => de.entry(y)?.shown.peek().place?.direction).map((y) => [y, { place: { direction: s, aim: m } }])
        );
        a.set({ lamps: h });
      },
      end: () => a.end(),
      cancel: () => a.cancel()
    };
  }
};
function io() {
  let e = to(null);
  return eo(() => st(e.current, ro).stop, []), so("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
function uo() {
  return null;
}

// src/later/legend.tsx
import { candles as co, display as po, Field as mo, show as ho, three as mt, useRef as go } from "./desk.js";
import { jsx as P, jsxs as me } from "./desk.js";
var Ve = [1, 2, 5];
function fo(e, t, n) {
  let a = [];
  if (n === "linear") {
    let l = (t - e) / 5, s = 10 ** Math.floor(Math.log10(l)), m = s * (Ve.find((h) => h * s >= l) ?? 10);
    for (let h = Math.ceil(e / m) * m; h <= t * 1.0001; h += m) a.push(h);
    return a;
  }
  for (let l = Math.floor(Math.log10(e)); l <= Math.ceil(Math.log10(t)); l++)
    for (let s of Ve) {
      let m = s * 10 ** l;
      m >= e * 0.999 && m <= t * 1.001 && a.push(m);
    }
  return a.length > 10 ? a.filter((l) => Math.abs(Math.log10(l) % 1) < 1e-6) : a;
}
function bo(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var I = (e, t) => {
  let n = { ...e, ...t };
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && ho({ false_color: n });
};
function ht(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return Ve[a] * 10 ** ((n - a) / 3);
}
function vo() {
  let e = po.value.false_color, t = go(null);
  if (!e) return null;
  let n = co.value === "fc", a = e.quantity === "illuminance", l = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", s = n ? a ? 1 / 10.7639 : 0.2919 : 1, m = e.colors, h = m?.length ? `linear-gradient(to top, ${m.join(", ")})` : void 0, y = (d) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: d, from: e[d] };
    },
    onPointerMove: (c) => {
      let L = t.current;
      L?.end === d && I(e, { [d]: ht(L.from, Math.round((L.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let L = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      L && (c.preventDefault(), c.stopPropagation(), I(e, { [d]: ht(e[d], L) }));
    }
  }), g = ({ end: d }) => me("div", { class: "end", children: [
    P(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": d === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[d],
        "aria-valuemin": 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${mt(e[d] * s)} ${l}`,
        ...y(d)
      }
    ),
    P(
      mo,
      {
        label: d === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[d] * s).toPrecision(3)),
        set: (c) => I(e, { [d]: c(e[d] * s) / s })
      }
    )
  ] });
  return me("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    me("header", { children: [
      P(
        "button",
        {
          "aria-label": `Quantity: ${a ? "illuminance" : "luminance"}`,
          onClick: () => I(e, { quantity: a ? "luminance" : "illuminance" }),
          children: l
        }
      ),
      P("button", { "aria-pressed": e.scale === "log", onClick: () => I(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      P("button", { "aria-pressed": e.lines, onClick: () => I(e, { lines: !e.lines }), children: "lines" })
    ] }),
    P(g, { end: "high" }),
    P("div", { class: "scale", style: { background: h }, children: fo(e.low, e.high, e.scale).map((d) => P("span", { style: { bottom: `${100 * bo(d, e)}%` }, children: mt(d * s) }, d)) }),
    P(g, { end: "low" }),
    me("footer", { children: [
      P("button", { onClick: () => I(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      P("button", { onClick: () => I(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      P(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (d) => I(e, { palette: d.currentTarget.value }),
          children: e.palettes?.map((d) => P("option", { children: d }, d)) ?? P("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
function yo() {
  return null;
}

// src/later/strip.tsx
import {
  act as yt,
  command as Lt,
  digits as Ee,
  fade as he,
  Field as $o,
  grids as kt,
  Icon as Z,
  looks as wt,
  luxText as J,
  maintenance as Mo,
  meters as xt,
  select as St,
  selection as ge,
  signal as Po,
  status as Te,
  storeLook as Vo
} from "./desk.js";

// src/later/csv.ts
import { add as gt, grids as ko, maintenance as wo, meters as xo, scale as ft, scene as bt } from "./desk.js";
var So = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function Co() {
  let e = wo.peek(), t = [["scene", bt.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of xo.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of ko.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [l, s] of Object.entries(a)) t.push([l, s === null ? null : s * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), n.lux.forEach((l, s) => {
      let [m, h] = [s % n.columns, Math.floor(s / n.columns)], y = gt(n.corner, gt(ft(n.u, (m + 0.5) / n.columns), ft(n.v, (h + 0.5) / n.rows)));
      t.push([...y.map((g) => g.toFixed(3)), l === null ? null : l * e]);
    });
  }
  return t.map((n) => n.map(So).join(",")).join(`\r
`) + `\r
`;
}
function Lo(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function vt() {
  let e = URL.createObjectURL(new Blob([Co()], { type: "text/csv" }));
  Lo(`${bt.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/strip.tsx
import { Fragment as Ho, jsx as p, jsxs as x } from "./desk.js";
var Ae = Po("looks");
function Eo() {
  return x("section", { class: "looks", "aria-label": "Looks", children: [
    x("header", { children: [
      p("h2", { children: "Looks" }),
      p("button", { class: "tab", onClick: () => Ae.value = "meters", children: "Meters" }),
      p("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: Vo, children: p(Z, { name: "plus" }) }),
      p("span", { class: "gap" }),
      x("label", { class: "tint", children: [
        "Fade",
        p($o, { label: "Cross-fade", quantity: "seconds", value: he.value, step: 0.5, set: (e) => he.value = Math.max(0, e(he.value)) })
      ] })
    ] }),
    x("ul", { children: [
      wt.all().map(([e, t], n) => x("li", { class: "look", children: [
        x("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Lt({ do: "look", id: e, what: "recall", seconds: he.peek() }), children: [
          t.picture && p("img", { src: t.picture, alt: "" }),
          p("span", { children: t.name })
        ] }),
        p(To, { id: e, name: t.name })
      ] }, e)),
      !wt.ids.value.length && p("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function To({ id: e, name: t }) {
  let n = `look-${e}`, a = (h) => {
    let y = h.getBoundingClientRect(), g = document.getElementById(n);
    g?.style.setProperty("left", `${Math.min(y.left, innerWidth - 296)}px`), g?.style.setProperty("bottom", `${innerHeight - y.top + 4}px`), g?.style.setProperty("top", "auto");
  }, l = { popovertarget: n }, s = () => document.getElementById(n)?.hidePopover(), m = (h, y = {}) => {
    s(), Lt({ do: "look", id: e, what: h, ...y });
  };
  return x(Ho, { children: [
    p("button", { class: "icon more", ...l, "aria-label": `More of ${t}`, onPointerDown: (h) => a(h.currentTarget), onFocus: (h) => a(h.currentTarget), children: p(Z, { name: "more" }) }),
    x("div", { id: n, popover: "auto", class: "menu", children: [
      x("label", { class: "line", children: [
        p("span", { children: "Name" }),
        p("span", { class: "field", children: p("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (h) => m("rename", { name: h.currentTarget.value }) }) })
      ] }),
      p("button", { class: "item", onClick: () => m("update"), children: p("span", { children: "Update to what is set now" }) }),
      p("button", { class: "item", onClick: () => m("recall", { seconds: 0 }), children: p("span", { children: "Recall at once" }) }),
      p("button", { class: "item", onClick: () => m("remove"), children: p("span", { children: "Remove" }) })
    ] })
  ] });
}
var Ct = () => Te.value?.stage === "moving" || Te.value?.stage === "refining" || Te.value?.stage === "loading";
function Ao() {
  let e = Mo.value;
  return x("section", { class: "readings", "aria-label": "Meters and grids", children: [
    x("header", { children: [
      p("h2", { children: "Meters" }),
      p("button", { class: "tab", onClick: () => Ae.value = "looks", children: "Looks" }),
      p("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => yt("meter-tool"), children: p(Z, { name: "meter" }) }),
      p("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => yt("grid"), children: p(Z, { name: "grid" }) }),
      p("button", { onClick: vt, title: "Save all figures as CSV", children: "CSV" }),
      p("span", { class: "gap" }),
      p("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${Ee(e, 2)} maintained` })
    ] }),
    x("ul", { children: [
      xt.all().map(([t, n]) => {
        let a = n.lux, l = !a || a[1] > 0.02 * a[0] || Ct();
        return p("li", { children: x("button", { class: "reading", "aria-pressed": ge.value?.kind === "meter" && ge.value.ids.includes(t), onClick: () => St("meter", t), children: [
          x("span", { class: "tint", children: [
            p(Z, { name: "meter" }),
            n.name
          ] }),
          p("strong", { class: l ? "unsettled" : "", children: a ? J(a[0] * e) : "…" }),
          x("small", { children: [
            a ? `±${J(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind
          ] })
        ] }) }, `m${t}`);
      }),
      kt.all().map(([t, n]) => {
        let a = n.target, l = a && n.mean !== null && n.uniformity !== null && n.mean * e >= a.lux && n.uniformity >= a.uniformity;
        return p("li", { children: x("button", { class: "reading", "aria-pressed": ge.value?.kind === "grid" && ge.value.ids.includes(t), onClick: () => St("grid", t), children: [
          x("span", { class: "tint", children: [
            p(Z, { name: "grid" }),
            n.name,
            " ",
            a && n.mean !== null && p("b", { class: l ? "met" : "missed", children: l ? "✓" : "✗" })
          ] }),
          p("strong", { class: Ct() ? "unsettled" : "", children: n.mean === null ? "…" : `Ē ${J(n.mean * e)}` }),
          x("small", { children: [
            "U₀ ",
            n.uniformity === null ? "…" : Ee(n.uniformity, 2),
            " · ",
            n.min === null ? "…" : J(n.min * e, !1),
            " to",
            " ",
            n.max === null ? "…" : J(n.max * e, !1),
            a ? ` · wants ${J(a.lux)}, U₀ ${Ee(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !xt.ids.value.length && !kt.ids.value.length && p("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Fo() {
  return x("div", { class: "strip-parts", "data-tab": Ae.value, children: [
    p(Eo, {}),
    p(Ao, {})
  ] });
}

// src/later/menus.tsx
import {
  digits as Io,
  display as Ro,
  Field as $t,
  go as qo,
  houseLights as Fe,
  Item as K,
  Range as Wo,
  show as He,
  theme as Mt,
  walking as Do
} from "./desk.js";
import { Fragment as Ie, jsx as v, jsxs as G } from "./desk.js";
function Go() {
  let e = ot();
  return G(Ie, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((t) => v(K, { id: t }, t)),
    v("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((t) => v(K, { id: `preset-${t}` }, t)),
    v("hr", {}),
    e.length > 0 && v("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    e.map(({ name: t, camera: n }, a) => v("button", { class: "item", onClick: () => qo(n, t), children: v("span", { children: t }) }, a)),
    e.length > 0 && v("hr", {}),
    v(K, { id: "walking", label: Do.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    v(K, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((t) => v(K, { id: `hands-${t}` }, t))
  ] });
}
var No = ["linear", "reinhard", "filmic"];
function Oo() {
  let e = Ro.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return G(Ie, { children: [
    G("fieldset", { children: [
      v("legend", { children: "Tone curve" }),
      v("div", { class: "segments", children: No.map((n) => v("button", { "aria-pressed": e.tone === n, onClick: () => He({ tone: n }), children: n }, n)) })
    ] }),
    G("fieldset", { children: [
      v("legend", { children: "White balance" }),
      G("label", { class: "line", children: [
        v("span", { children: "White" }),
        v($t, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => He({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      G("label", { class: "line", children: [
        v("span", { children: "Tint" }),
        v($t, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => He({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    v("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => v(K, { id: n }, n))
  ] });
}
function Bo() {
  return G(Ie, { children: [
    G("label", { class: "line", children: [
      v("span", { children: "House lights" }),
      v(Wo, { label: "House lights", value: Fe.value, text: `${Io(Fe.value * 100)} %`, on: (e) => Fe.value = Math.max(0.3, e) })
    ] }),
    v("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => v("button", { "aria-pressed": Mt.value === e, onClick: () => Mt.value = e, children: e }, e)) }),
    v("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => v(K, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as fe, cut as Uo, digits as Pt, edit as Vt, go as Ko, Icon as le, Range as zo, setCut as _o, storeView as Xo, viewName as Yo, views as Jo } from "./desk.js";
import { jsx as V, jsxs as be } from "./desk.js";
function Zo() {
  let e = Jo.all();
  return be("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    V("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => fe("home"), children: V(le, { name: "home" }) }),
    V("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => fe("frame"), children: V(le, { name: "frame" }) }),
    V("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => fe("back"), children: V(le, { name: "back" }) }),
    V("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => fe("forth"), children: V(le, { name: "forth" }) }),
    V("span", { class: "divide" }),
    e.map(([t, n], a) => be(
      "button",
      {
        class: "saved-view",
        "aria-pressed": Yo.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click to rename, Delete to remove`,
        onClick: () => Ko(n, n.name ?? "view"),
        onDblClick: () => {
          let l = prompt("Name of the view", n.name ?? "");
          l && Vt(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (l) => {
          l.key === "Delete" && (l.stopPropagation(), Vt(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          V("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    V("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: Xo, children: V(le, { name: "plus" }) })
  ] });
}
function jo() {
  let e = Uo.value;
  return e ? be("label", { class: "cut", "data-scroll": !0, children: [
    V("span", { children: "Cut" }),
    V(
      zo,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: `${Pt(e.value, 2)} metres`,
        on: (t) => _o(t * e.most)
      }
    ),
    be("output", { children: [
      Pt(e.value, 2),
      " m"
    ] })
  ] }) : null;
}

// src/later/walkpad.tsx
import { padWalk as Qo, useRef as ea } from "./desk.js";
import { jsx as Et } from "./desk.js";
function ta() {
  let e = ea(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let l = n.type === "pointerup" || n.type === "pointercancel";
    if (!l && !a.hasPointerCapture(n.pointerId)) return;
    let s = a.getBoundingClientRect(), m = (g) => Math.max(-1, Math.min(1, g)), h = l ? 0 : m((n.clientX - s.left) / (s.width / 2) - 1), y = l ? 0 : m(1 - (n.clientY - s.top) / (s.height / 2));
    e.current?.style.setProperty("transform", `translate(${h * 28}px, ${-y * 28}px)`), Qo(y, h);
  };
  return Et("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: Et("span", { ref: e }) });
}

// src/later/what.tsx
import {
  addMeter as na,
  aim as oa,
  chosenLamps as Tt,
  closeWhat as At,
  digits as aa,
  hovered as Ft,
  Icon as la,
  luxText as N,
  nameOf as ra,
  select as ia,
  useEffect as sa,
  useRef as ua,
  viewSize as ca,
  what as pa
} from "./desk.js";
import { jsx as C, jsxs as A } from "./desk.js";
var z = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], da = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function ma() {
  let e = pa.value, t = ua(null);
  if (sa(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = ca.value, l = [...e.lamps].sort((c, L) => z(L) - z(c)), s = l.reduce((c, L) => c + z(L), 0) || 1, m = l.slice(0, 9), h = s - m.reduce((c, L) => c + z(L), 0), y = Math.max(8, Math.min(e.x + 12, n - 332)), g = Math.max(8, Math.min(e.y + 12, a - 120 - 28 * Math.min(l.length, 10))), d = e.lux ? `${N(e.lux[0])} ±${N(e.lux[1], !1)}` : "Measuring…";
  return A(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${y}px`, top: `${g}px` },
      onKeyDown: (c) => {
        c.key === "Escape" && (c.stopPropagation(), At(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        A("header", { children: [
          C("strong", { class: e.done ? "" : "unsettled", children: d }),
          C("span", { class: "quiet", children: "what lights this" }),
          C("button", { class: "icon", "aria-label": "Close", onClick: At, children: C(la, { name: "close" }) })
        ] }),
        A("ol", { children: [
          m.map((c) => C(
            "li",
            {
              onPointerEnter: () => Ft.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => Ft.value = null,
              children: A("button", { class: "row", onClick: () => ia("lamp", c.id), children: [
                C("span", { class: "name", children: ra("lamp", c.id) }),
                A("span", { class: "figure", children: [
                  aa(100 * z(c) / s, z(c) / s < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                A("span", { class: "figure lux", children: [
                  N(z(c)),
                  " ±",
                  N(da(c), !1)
                ] }),
                A("span", { class: "bar", "aria-hidden": "true", children: [
                  C("i", { class: "direct", style: { width: `${100 * c.direct[0] / s}%` } }),
                  C("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / s}%` } }),
                  C("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / s}%` } })
                ] }),
                A("span", { class: "spoken", children: [
                  "direct ",
                  N(c.direct[0]),
                  ", indirect ",
                  N(c.indirect[0]),
                  ", caustic",
                  " ",
                  N(c.caustic[0])
                ] })
              ] })
            },
            c.id
          )),
          l.length > m.length && A("li", { class: "quiet", children: [
            "and ",
            l.length - m.length,
            " others, ",
            N(h),
            " together"
          ] }),
          !l.length && C("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        A("footer", { children: [
          C("span", { class: "key direct", children: "direct" }),
          C("span", { class: "key indirect", children: "indirect" }),
          C("span", { class: "key caustic", children: "caustic" }),
          C("span", { class: "gap" }),
          Tt.value.length > 0 && C("button", { onClick: () => oa(Tt.peek(), e.hit.point), children: "Aim here" }),
          C("button", { onClick: () => na(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Vn as Compare,
  jo as CutBar,
  io as Gizmo,
  uo as Inspector,
  vo as Legend,
  Bo as PageItems,
  Oo as SeeingItems,
  yo as Sheets,
  Fo as Strip,
  Go as ViewItems,
  Zo as ViewStrip,
  ta as WalkPad,
  ma as What
};
