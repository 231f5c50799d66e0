// src/later/actions.ts
import {
  adding as Ei,
  asked as Ii,
  ask as Ai,
  back as Ri,
  candles as Jo,
  chosenLamps as de,
  clearSolo as qi,
  command as Sn,
  compareHeld as Fi,
  copyText as Hi,
  DEFAULT_FALSE as Ni,
  deselect as Di,
  each as Ln,
  edit as Tn,
  exposeBy as ea,
  falseColor as Gi,
  fine as ta,
  forth as Oi,
  frameSelection as Wi,
  go as Ki,
  goHome as Bi,
  goInside as Ui,
  goPreset as _i,
  hands as Xi,
  here as Yi,
  highlight as zi,
  history as na,
  lampMarks as oa,
  lamps as It,
  listing as aa,
  lookOnly as la,
  looks as ji,
  maintenance as Zi,
  panels as ra,
  PRESETS as Qi,
  register as Ji,
  say as ot,
  scene as es,
  selection as ma,
  send as ts,
  sheet as tt,
  show as Cn,
  soloSelection as ns,
  spot as nt,
  startTool as Se,
  stepSelection as ia,
  storeLook as os,
  storeView as as,
  theme as sa,
  things as ua,
  titleOf as da,
  toggleFalse as ls,
  toggleWipe as rs,
  travel as ca,
  views as is,
  walking as $n,
  whyNot as _
} from "./desk.js";

// src/later/differ.ts
var ft = (e) => ({
  quantity: "difference",
  against: e,
  low: -500,
  high: 500,
  scale: "linear",
  palette: "diverging",
  lines: !1
});
function go(e) {
  let t = Math.min(1e6, Math.max(0.01, e.high));
  return { ...e, low: -t, high: t, scale: "linear" };
}

// src/later/grouping.ts
import { chosenLamps as et, groups as St, lamps as kr, selection as Ct, step as Po, titleOf as Vo } from "./desk.js";

// src/later/tools.ts
import {
  add as yt,
  adding as rr,
  chosenLamps as wo,
  distance as ir,
  dot as sr,
  edit as kt,
  effect as ur,
  free as Co,
  grids as xo,
  lamps as Ee,
  meters as Mo,
  normal as $o,
  onTool as cr,
  positionOf as pr,
  say as wt,
  scale as vt,
  select as mr,
  step as vn,
  sub as yn,
  titleOf as xt,
  tool as ke,
  untracked as dr,
  up as Lo,
  workPlane as hr
} from "./desk.js";

// src/later/area.ts
import { ask as zl, camera as jl, cross as Zl, dot as ye, effect as bo, add as fn, normal as Ql, scale as Ve, scene as vo, selection as Jl, signal as er, sub as tr, tool as nr } from "./desk.js";
var or = 0.5, ar = 0.3;
function lr(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
var gt = (e, t = 0) => e > 2 * t ? e - 2 * t : e;
function bn(e) {
  let [t, n] = [Math.min(...e), Math.max(...e)], o = n >= 2 * t ? t : n, a = o / Math.max(1, Math.round(o / lr(o)));
  return e.map((l) => Math.max(1, Math.round(l / a)));
}
function yo(e, t, n, o, a) {
  let l = Math.abs(n[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], r = Ql(Zl(n, l)), s = tr(t.point, e.point), [p, i] = [ye(s, l), ye(s, r)];
  if (Math.abs(p) < 0.05 || Math.abs(i) < 0.05) return null;
  let m = (ee) => ye(ee, n) - o, c = [e, t].every((ee) => ye(ee.normal, n) > 0.7 && m(ee.point) > ar), g = c ? 0 : or, u = c ? 0 : a - m(e.point), h = fn(fn(e.point, Ve(n, u)), fn(Ve(l, Math.min(p, 0)), Ve(r, Math.min(i, 0)))), v = [Math.abs(p), Math.abs(i)], [E, H] = bn(v.map((ee) => gt(ee, g)));
  return { corner: h, u: Ve(l, v[0]), v: Ve(r, v[1]), normal: n, columns: E, rows: H, border: g };
}
var ko = er(null);
function bt() {
  let e = vo.value;
  return ko.value ?? (e ? Math.min(ye(e.bounds[0], e.up), ye(e.bounds[1], e.up)) : 0);
}
var gn = null;
bo(() => {
  let e = jl.value;
  e && !e.height && (gn = e.eye);
});
bo(() => {
  let e = vo.value?.up;
  !e || !gn || nr.value !== "grid" && Jl.value?.kind !== "grid" || zl("ray", { origin: gn, direction: Ve(e, -1) }, (t) => {
    t.hit && (ko.value = ye(t.point, e));
  });
});

// src/later/tools.ts
var Ye = null, fr = { lux: 500, uniformity: 0.6 };
ur(() => {
  ke.value !== "grid" && (Ye = null);
});
function gr(e) {
  if (!e) return wt("There is nothing at that point.", "warn");
  switch (ke.peek()) {
    case "aim":
      ze(wo.peek(), e.point), ke.value = null;
      break;
    case "place":
      br(wo.peek(), e), ke.value = null;
      break;
    case "meter":
      Ze(e.point, e.normal), ke.value = null;
      break;
    case "grid":
      if (!Ye) {
        Ye = e;
        return;
      }
      vr(Ye, e), Ye = null, ke.value = null;
      break;
    case "add":
      yr(rr.peek(), e), ke.value = null;
      break;
  }
}
cr(gr);
function ze(e, t) {
  let n = {};
  for (let o of e) {
    let a = Ee.get(o)?.place;
    !a?.position || !a.direction || (n[o] = { place: { aim: t, direction: $o(yn(t, a.position)) } });
  }
  if (!Object.keys(n).length) return wt("What is selected shines into all directions: it cannot be aimed.", "warn");
  kt(`Aim ${xt(e)}`, { lamps: n });
}
function je(e, t) {
  let n = new Set(e.ids.peek()), o = e.ids.subscribe((a) => {
    let l = a.filter((r) => !n.has(r));
    l.length && (mr(t, l[l.length - 1]), queueMicrotask(() => o()));
  });
  setTimeout(() => o(), 3e3);
}
function br(e, t) {
  let n = Je(e), o = n.get(e[e.length - 1]);
  if (!o) return wt("What is selected has no place.", "warn");
  let a = (Ee.get(e[e.length - 1])?.place?.radius ?? 0) + 0.02;
  kt(`Put ${xt(e)} on a surface`, Qe(e, yn(yt(t.point, vt(t.normal, a)), o), n));
}
function Ze(e, t) {
  let n = Co(Mo);
  je(Mo, "meter"), kt("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function vr(e, t) {
  let n = yo(e, t, Lo.peek(), dr(bt), hr.peek());
  if (!n) return wt("An area needs two corners that lie apart.", "warn");
  let o = Co(xo);
  je(xo, "grid"), kt("Lay a grid", { grids: { [o]: { name: `Area ${o + 1}`, ...n, target: fr } } });
}
var So = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function yr(e, t) {
  let n = Lo.peek(), o = sr(t.normal, n), a = o > 0.7 ? yt(t.point, vt(n, 1.2)) : yt(t.point, vt(t.normal, 0.15)), l = o > 0.7 || o < -0.7 ? vt(n, -1) : t.normal, r = { position: a };
  e !== "point" && e !== "sphere" && (r.direction = l), e === "spot" && Object.assign(r, { inner: 24, outer: 36, ...o > 0.7 ? { aim: t.point } : {} }), e === "disc" && (r.radius = 0.15), e === "sphere" && (r.radius = 0.08);
  let s = Ee.all().filter(([, p]) => p.own).length;
  je(Ee, "lamp"), vn(`Add ${So[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${So[e] ?? e} ${s + 1}`, kind: e, flux: 800, place: r }
  });
}
function Mt(e, t, n) {
  !e.length || t < 1 || vn(`Copy ${xt(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function To(e) {
  e.length && vn(`Remove ${xt(e)}`, { do: "remove", lamps: e });
}
function Qe(e, t, n) {
  let o = {};
  for (let a of e) {
    let l = Ee.get(a)?.place, r = n.get(a);
    if (!r) continue;
    let s = yt(r, t), p = l?.aim && ir(l.aim, s) > 1e-6 ? { direction: $o(yn(l.aim, s)) } : {};
    o[a] = { place: { position: s, ...p } };
  }
  return { lamps: o };
}
function Je(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let o = Ee.get(n), a = o && pr(o);
    a && t.set(n, a);
  }
  return t;
}

// src/later/grouping.ts
var Eo = (e) => {
  let t = kr.get(e)?.group ?? null;
  return t !== null && (St.get(t)?.lamps.length ?? 0) > 1 ? t : null;
};
function $t() {
  return et.value.length < 2 ? "Select two lamps or more first." : Ct.value?.kind === "group" && Ct.value.ids.length === 1 ? "This is a group already." : null;
}
function Io() {
  let e = new Set(St.all().map(([, n]) => n.name)), t = 1;
  for (; e.has(`Group ${t}`); ) t++;
  je(St, "group"), Po(`Group ${Vo(et.peek())}`, { do: "group", lamps: et.peek(), name: `Group ${t}` });
}
function Lt() {
  return et.value.some((e) => Eo(e) !== null) ? null : "What is selected is in no group.";
}
function Ao() {
  let e = Ct.peek(), t = et.peek().filter((o) => Eo(o) !== null), n = e?.kind === "group" && e.ids.length === 1 ? St.get(e.ids[0]) : void 0;
  Po(n ? `Dissolve ${n.name}` : `Take ${Vo(t)} out`, { do: "group", lamps: t }), Ct.value = { kind: "lamp", ids: t };
}

// src/later/most.ts
import { signal as wr } from "./desk.js";
var Ie = wr(1);

// src/later/there.ts
import { add as xr, dot as Ro, go as Mr, here as Sr, moved as Cr, scale as $r, spot as Lr, sub as Tr, up as Pr, walking as Vr, EYE_HEIGHT as Er } from "./desk.js";
var Ir = 1.2;
function Ar(e, t, n) {
  let o = Tr(n.point, e.eye);
  return e.height || Ro(n.normal, t) < 0.9 || Ro(o, t) > -Ir ? null : Cr(e, xr(o, $r(t, Er)));
}
function qo() {
  let [e, t] = [Sr(), Lr.value];
  return e && t && Vr.value === "walk" ? Ar(e, Pr.value, t) : null;
}
var Fo = () => qo() ? null : "Point at the floor first, walking.";
function Ho() {
  let e = qo();
  e && Mr(e, "there");
}

// src/later/typed.tsx
import { effect as di, handles as hi, keysFirst as fi, role as gi, say as bi, scale as vi, selection as yi, signal as ki, tool as wi, untracked as xi } from "./desk.js";

// src/later/handles.tsx
import {
  add as Ko,
  chosenLamps as Wr,
  computed as xn,
  editor as Kr,
  effect as Br,
  fitted as Ur,
  Gesture as _r,
  handles as Xr,
  lamps as Pt,
  lookOnly as Yr,
  middle as zr,
  nameOf as jr,
  normal as Zr,
  pinhole as Qr,
  positionOf as Uo,
  role as Jr,
  selection as ei,
  shown as ti,
  sub as ni,
  things as Vt,
  titleOf as oi,
  tool as ai,
  turn as Bo,
  useEffect as li,
  useRef as ri,
  viewSize as ii
} from "./desk.js";

// src/later/gizmo.ts
import { project as No, ray as Rr } from "./desk.js";
import { across as qr, add as re, cross as Fr, distance as Hr, dot as me, length as Nr, normal as kn, scale as ie, sub as Ae } from "./desk.js";
var Dr = "http://www.w3.org/2000/svg", wn = 84, we = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], Tt = ["x", "y", "z"], Do = 0.1, Gr = 5 * Math.PI / 180, Go = 48;
function Wo(e, t) {
  let n = (d, b, k) => {
    let w = document.createElementNS(Dr, d);
    return w.setAttribute("class", k), b.append(w), w;
  }, o = (d, b, k) => {
    let w = n("g", e, `handle ${d} ${Tt[b] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, a = n("path", e, "aim-line"), l = we.map((d, b) => o("ring", b, `ring-${Tt[b]}`)), r = we.map((d, b) => o("plane", b, `plane-${Tt[b]}`)), s = we.map((d, b) => o("arrow", b, `move-${Tt[b]}`)), p = o("centre", -1, "move-view"), i = o("aim", -1, "aim"), m = n("text", e, "handle-text"), c = (d, b) => {
    let [k, w, I] = No(d.hole, b);
    return I < 0.02 && !d.hole.parallel ? null : [d.fit.x + k * d.fit.scale, d.fit.y + w * d.fit.scale];
  }, g = (d, b) => {
    let k = No(d.hole, b)[2];
    return wn / d.fit.scale * d.hole.pixel * (d.hole.parallel ? 1 : Math.max(k, 0.02));
  }, u = (d, b, k = !1) => {
    let w = b.filter(($) => $ !== null), I = w.length < b.length || w.length < 2 ? "" : `M${w.map(($) => `${$[0].toFixed(1)} ${$[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    d.setAttribute("d", I);
  }, h = (d, b, k) => {
    d.setAttribute("d", b ? `M${b[0] - k} ${b[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, v = (d, b) => d.forEach((k) => k.group.classList.toggle("gone", !b));
  function E(d, b) {
    let k = d.position, w = c(b, k), I = g(b, k), $ = d.mode === "move";
    v([...s, ...r, p], $ && w !== null), v(l, !$ && w !== null && d.turns);
    let z = d.aim ?? (d.direction ? re(k, ie(d.direction, 3 * I)) : null);
    if (v([i], z !== null && w !== null), !w) {
      a.setAttribute("d", "");
      return;
    }
    we.forEach((O, U) => {
      let q = c(b, re(k, ie(O, I))), mt = q ? Math.hypot(q[0] - w[0], q[1] - w[1]) < 12 : !0;
      if (s[U].group.classList.toggle("gone", !$ || mt), q && $) {
        let [ve, _e] = [(q[0] - w[0]) / wn, (q[1] - w[1]) / wn], ht = Math.hypot(ve, _e) || 1, [pe, Xe] = [ve / ht, _e / ht], hn = [w[0] + 14 * pe, w[1] + 14 * Xe];
        u(s[U].hit, [hn, q]), s[U].seen.setAttribute("d", `M${hn[0].toFixed(1)} ${hn[1].toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}M${(q[0] - 9 * pe - 4.5 * Xe).toFixed(1)} ${(q[1] - 9 * Xe + 4.5 * pe).toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}L${(q[0] - 9 * pe + 4.5 * Xe).toFixed(1)} ${(q[1] - 9 * Xe - 4.5 * pe).toFixed(1)}`);
      }
      let [Be, Ue] = [we[(U + 1) % 3], we[(U + 2) % 3]], Z = Math.abs(me(O, b.hole.parallel ? b.hole.forward : kn(Ae(k, b.hole.eye)))) < 0.15;
      r[U].group.classList.toggle("gone", !$ || Z);
      let dt = (ve, _e) => c(b, re(k, re(ie(Be, ve * I), ie(Ue, _e * I)))), fo = [dt(0.3, 0.3), dt(0.5, 0.3), dt(0.5, 0.5), dt(0.3, 0.5)];
      if (u(r[U].hit, fo, !0), u(r[U].seen, fo, !0), !$) {
        let ve = Array.from({ length: Go + 1 }, (_e, ht) => {
          let pe = 2 * Math.PI * ht / Go;
          return c(b, re(k, re(ie(Be, Math.cos(pe) * I), ie(Ue, Math.sin(pe) * I))));
        });
        u(l[U].hit, ve), u(l[U].seen, ve);
      }
    }), h(p.hit, w, 13), h(p.seen, w, 7);
    let R = z && c(b, z);
    u(a, [w, R]), h(i.hit, R, 16), i.seen.setAttribute("d", R ? `M${R[0] - 8} ${R[1]}h16M${R[0]} ${R[1] - 8}v16M${R[0] - 5} ${R[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let H = t.effect(() => {
    let d = t.target.value, b = t.view.value;
    e.classList.toggle("empty", !d || !b), d && b && E(d, b);
  }), ee = (d, b, k) => Rr(d.hole, (b.clientX - k.left - d.fit.x) / d.fit.scale, (b.clientY - k.top - d.fit.y) / d.fit.scale);
  function be(d, b, k) {
    d.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let I = t.view.peek();
      if (!I || !t.target.peek()) return;
      let $ = e.getBoundingClientRect(), z = k(I), R = t.hold(b), O = ee(I, w, $);
      z(O, !1, { ...R, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), d.setPointerCapture(w.pointerId), d.classList.add("held");
      let U = (Z) => {
        m.textContent = z(ee(I, Z, $), Z.ctrlKey || Z.metaKey, R), m.setAttribute("x", String(Z.clientX - $.left + 16)), m.setAttribute("y", String(Z.clientY - $.top - 12));
      }, q = (Z) => {
        d.removeEventListener("pointermove", U), d.removeEventListener("pointerup", mt), d.removeEventListener("pointercancel", Be), removeEventListener("keydown", Ue, !0), d.classList.remove("held"), m.textContent = "", Z ? R.end() : R.cancel();
      }, mt = () => q(!0), Be = () => q(!1), Ue = (Z) => {
        Z.key === "Escape" && (Z.stopPropagation(), q(!1));
      };
      d.addEventListener("pointermove", U), d.addEventListener("pointerup", mt), d.addEventListener("pointercancel", Be), addEventListener("keydown", Ue, !0);
    });
  }
  let mn = (d, b, k) => k ? Math.round(d / b) * b : d, dn = (d) => d.map((b) => b.toFixed(2)).join("  ") + " m";
  we.forEach((d, b) => {
    be(s[b].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (I, $, z) => {
        let R = Or(k, d, I);
        w ??= R;
        let O = ie(d, mn(R - w, Do, $));
        return z.move(O), dn(O);
      };
    }), be(r[b].group, "move", () => mo(d)), be(l[b].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (I, $, z) => {
        let R = Oo(k.position, d, I), O = R && kn(Ae(R, k.position), qr(d));
        if (!O) return "";
        w.at ??= O;
        let U = Math.atan2(me(d, Fr(w.at, O)), me(w.at, O)), q = mn(U, Gr, $);
        return z.rotate(d, q), `${(q * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), be(p.group, "move", (d) => mo(d.hole.forward)), be(i.group, "aim", (d) => {
    let b = t.target.peek(), k = b.aim ?? re(b.position, ie(b.direction, 3 * g(d, b.position))), w = ho(k, d.hole.forward);
    return (I, $, z) => {
      let R = w(I, $), O = re(k, R);
      return Hr(O, b.position) > 1e-3 && z.turn(kn(Ae(O, b.position)), O), dn(O);
    };
  });
  function mo(d) {
    let b = ho(t.target.peek().position, d);
    return (k, w, I) => {
      let $ = b(k, w);
      return I.move($), dn($);
    };
  }
  function ho(d, b) {
    let k = null;
    return (w, I) => {
      let $ = Oo(d, b, w);
      return $ ? (k ??= $, Ae($, k).map((z) => mn(z, Do, I))) : [0, 0, 0];
    };
  }
  return { stop: H };
}
function Or(e, t, n) {
  let o = Ae(e, n.origin), a = me(t, n.direction), l = 1 - a * a;
  return l < 1e-6 ? 0 : (a * me(n.direction, o) - me(t, o)) / l;
}
function Oo(e, t, n) {
  let o = me(t, n.direction);
  if (Math.abs(o) < 1e-4 * Nr(t)) return null;
  let a = me(Ae(e, n.origin), t) / o;
  return a < 0 || a > 1e6 ? null : re(n.origin, ie(n.direction, a));
}

// src/later/handles.tsx
import { jsx as mi } from "./desk.js";
function si([e, t, n, o], [a, l, r, s]) {
  return [
    o * a + e * s + t * r - n * l,
    o * l - e * r + t * s + n * a,
    o * r + e * l - t * a + n * s,
    o * s - e * a - t * l - n * r
  ];
}
var ui = () => !Yr.value && Jr.value !== "watch" && Kr.value.you && ai.value !== "aim", _o = xn(() => {
  let e = ei.value;
  if (!e || !ui()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((o) => Vt.get(o) && !Vt.get(o)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = Wr.value.filter((n) => Uo(Pt.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), Xo = (e) => {
  let t = Vt.get(e);
  return t?.place?.position ?? (t?.box ? zr(t.box) : null);
}, Yo = xn(() => {
  let e = _o.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? Uo(Pt.get(t)) : Xo(t);
  if (!n) return null;
  let o = e.kind === "lamps" ? Pt.get(t)?.place : null;
  return {
    position: n,
    direction: o?.direction ?? null,
    aim: o?.aim ?? null,
    turns: e.kind === "things" || !!o?.direction || !!o?.rotation,
    mode: Xr.value
  };
}), ci = xn(() => {
  let e = ti.value;
  if (ii.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: Qr(e.camera, t, n), fit: Ur(t, n) };
}), zo = {
  effect: Br,
  target: Yo,
  view: ci,
  hold(e) {
    let t = _o.peek(), n = t?.ids ?? [], o = t?.kind ?? "lamps", a = o === "lamps" ? oi(n) : n.length === 1 ? jr("thing", n[0]) : `${n.length} things`, l = new _r(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${a}`), r = o === "lamps" ? Je(n) : new Map(n.map((i) => [i, Xo(i)])), s = new Map(n.map((i) => [i, (o === "lamps" ? Pt : Vt).get(i)?.place])), p = (i) => {
      let m = n.map((c) => [c, i(c)]).filter(([, c]) => c);
      l.set({ [o]: Object.fromEntries(m.map(([c, g]) => [c, { place: g }])) });
    };
    return {
      move: (i) => o === "lamps" ? l.set(Qe(n, i, r)) : p((m) => ({ position: Ko(r.get(m), i) })),
      turn: (i, m) => p((c) => s.get(c)?.direction ? { direction: i, ...m ? { aim: m } : {} } : null),
      rotate: (i, m) => p((c) => {
        let g = s.get(c);
        if (g?.direction) {
          let v = Zr(Bo(g.direction, i, m)), E = g.aim && g.position ? Bo(ni(g.aim, g.position), i, m) : null;
          return { direction: v, ...E ? { aim: Ko(g.position, E) } : {} };
        }
        let u = Math.sin(m / 2), h = [i[0] * u, i[1] * u, i[2] * u, Math.cos(m / 2)];
        return { rotation: si(h, g?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => l.end(),
      cancel: () => l.cancel()
    };
  }
}, jo = (e) => Yo.peek() ? zo.hold(e) : null;
function pi() {
  let e = ri(null);
  return li(() => Wo(e.current, zo).stop, []), mi("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/typed.tsx
import { jsx as Vi, jsxs as Qo } from "./desk.js";
var Mi = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], Si = { Minus: "-", NumpadSubtract: "-", Period: ".", Comma: ".", NumpadDecimal: "." }, Zo = { Enter: "keep", Escape: "leave", Backspace: "back" };
function Ci({ key: e, code: t }) {
  if (Zo[e]) return { does: Zo[e] };
  let n = e.length === 1 ? "xyz".indexOf(e.toLowerCase()) : -1;
  if (n >= 0) return { axis: n };
  if (/^\d$/.test(e)) return { sign: e };
  if (/^[.,]$/.test(e)) return { sign: "." };
  if (/^[-−]$/.test(e)) return { sign: "-" };
  if (/^[a-z]$/i.test(e)) return {};
  let o = ["KeyX", "KeyY", "KeyZ"].indexOf(t);
  if (o >= 0) return { axis: o };
  let a = /^(?:Digit|Numpad)(\d)$/.exec(t)?.[1] ?? Si[t];
  return a ? { sign: a } : {};
}
function $i(e, t) {
  return t === "-" ? e.startsWith("-") ? e.slice(1) : `-${e}` : t === "." && e.includes(".") ? e : e.length < 9 ? e + t : e;
}
var Li = (e) => Number(e) || 0, Re = ki(null), Me = null;
function Mn(e) {
  xe(!0), hi.value = e, wi.value = null, Re.value = { what: e, axis: null, text: "" };
}
function xe(e) {
  Re.peek() && (Re.value = null, e ? Me?.end() : Me?.cancel(), Me = null);
}
function Et(e) {
  Re.value = e;
  let t = Mi[e.axis ?? 0], n = Li(e.text);
  e.what === "move" ? Me?.move(vi(t, n)) : Me?.rotate(t, n * Math.PI / 180);
}
function Ti(e) {
  let t = Re.peek();
  if (!t || e.key === "Shift") return !1;
  let n = e.ctrlKey || e.metaKey || e.altKey, { axis: o, sign: a, does: l } = n ? {} : Ci(e);
  if (t.axis === null)
    return o === void 0 ? (xe(!1), l === "leave") : (Me = jo(t.what), Me ? Et({ ...t, axis: o }) : (xe(!1), bi("Select lamps that have a place, or things that are not locked.", "warn")), !0);
  if (n)
    return xe(!0), !1;
  if (o !== void 0) Et({ ...t, axis: o });
  else if (a) Et({ ...t, text: $i(t.text, a) });
  else if (l === "back") Et({ ...t, text: t.text.slice(0, -1) });
  else if (l) xe(l === "keep");
  else return e.key.length === 1;
  return !0;
}
fi(Ti);
addEventListener("pointerdown", (e) => xe(e.button !== 2), !0);
di(() => {
  yi.value, xi(() => xe(!0));
});
function Pi() {
  let e = Re.value;
  if (!e || gi.value === "watch") return null;
  let t = e.what === "move" ? "Move" : "Turn";
  return e.axis === null ? Qo("p", { class: "hint", role: "status", children: [
    t,
    ": X, Y or Z, then ",
    e.what === "move" ? "metres" : "degrees",
    "; or drag a handle."
  ] }) : Qo("p", { class: "hint", role: "status", children: [
    t,
    " ",
    e.what === "move" ? "along" : "about",
    " ",
    "XYZ"[e.axis],
    ": ",
    Vi("b", { children: e.text || "0" }),
    e.what === "move" ? " m" : "°",
    ". Enter keeps it, Esc takes it back."
  ] });
}

// src/later/actions.ts
var se = () => _() ?? (de.value.length ? null : "Select a lamp first.");
function ss() {
  let e = de.peek(), t = !e.some((n) => It.get(n)?.on);
  Tn(`${da(e)} ${t ? "on" : "off"}`, { lamps: Ln(e, { on: t }) });
}
function us() {
  let e = de.peek(), t = !e.every((n) => It.get(n)?.parked);
  Tn(`${t ? "Park" : "Unpark"} ${da(e)}`, { lamps: Ln(e, { parked: t }) });
}
function pa(e) {
  let t = ma.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : ua.ids.peek().filter((o) => ua.get(o)?.hidden);
  if (!n.length) return ot(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Tn(e ? "Hide things" : "Show hidden things", { things: Ln(n, { hidden: e }) });
}
function cs() {
  let e = de.peek()[0], t = It.get(e)?.place, n = Yi();
  if (!t?.position || !t.direction || !n) return ot("Select a lamp that has a direction.", "warn");
  let { position: o, direction: a } = t;
  Ki({ ...n, eye: o, target: [o[0] + a[0], o[1] + a[1], o[2] + a[2]], height: null, near: null }, "from the lamp");
}
function ps() {
  Ai("command", {}, (e) => {
    Hi(e.text);
  });
}
var ms = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], ds = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, hs = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: Wi },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: Bi },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: Ui },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: Ri },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: Oi },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: as, why: _ },
  ...Qi.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: ds[e],
    keys: `Shift+${t + 1}`,
    run: () => _i(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      $n.value = $n.peek() === "walk" ? "fly" : "walk", ot($n.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "there", group: "View", label: "Go to the floor under the pointer", keys: "double click", run: Ho, why: Fo },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: cs, why: se },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => ia(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => ia(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => Se("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => ma.value = { kind: "lamp", ids: It.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: Di },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: ss, why: se },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: ns, why: () => de.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: qi },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => zi(!0), why: se },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: us, why: se },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => Se("aim"), why: se },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => nt.peek() && ze(de.peek(), nt.peek().point), why: se },
  { id: "place", group: "Lamps", label: "Put on a surface by pointing", keys: "Shift+N", run: () => Se("place"), why: se },
  { id: "move", group: "Lamps", label: "Move: handles, or an axis and metres", keys: "G, then X Y Z, 0.5", run: () => Mn("move") },
  { id: "turn", group: "Lamps", label: "Turn: handles, or an axis and degrees", keys: "R, then X Y Z, 30", run: () => Mn("turn") },
  ...ms.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: _,
    run: () => {
      Ei.value = e, Se("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => Mt(de.peek(), 1, [0.5, 0, 0]), why: se },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => To(de.peek()), why: se },
  { id: "group", group: "Lamps", label: "Group: one master for those selected", keys: "Ctrl+G", run: Io, why: () => _() ?? $t() },
  { id: "ungroup", group: "Lamps", label: "Dissolve the group, or take lamps out of it", keys: "Ctrl+Shift+G", run: Ao, why: () => _() ?? Lt() },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => pa(!0), why: _ },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => pa(!1), why: _ },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => Sn({ do: "undo" }), why: () => _() ?? (na.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => Sn({ do: "redo" }), why: () => _() ?? (na.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => tt.value = "save", why: _ },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => tt.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: ps },
  { id: "share", group: "Work", label: "Share by link", run: () => tt.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: ls },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = Gi();
      e.against != null ? Cn({ false_color: Ni }) : Cn({ false_color: { ...Ii(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  {
    id: "difference",
    group: "Seeing",
    label: "Difference in lux to the look stored last",
    run: () => {
      let e = ji.ids.peek().at(-1);
      e === void 0 ? ot("Store a look first.") : Cn({ false_color: ft(e) });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => ea(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => ea(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => ts({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => Fi(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: rs },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: _, run: () => nt.peek() ? Ze(nt.peek().point, nt.peek().normal) : Se("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => Se("meter"), why: _ },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => Se("grid"), why: _ },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => Sn({ do: "reach", most: Ie.peek(), maintenance: Zi.peek() }), why: _ },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => Jo.value = Jo.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: os, why: _ },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => ot("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => ra.value = !ra.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => aa.value = aa.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => ca.value = ca.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => oa.value = !oa.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => ta.value = !ta.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => sa.value = sa.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => la.value = !la.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => Xi.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => tt.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => tt.value = "palette" }
];
Ji(hs);
function At() {
  return [...(es.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...is.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/shares.ts
import { ask as fs, computed as gs, effect as ha, lamps as bs, output as vs, untracked as ys, what as Pn } from "./desk.js";
var ks = gs(() => Pn.value?.hit ?? null), fa = (e) => fs("light", { point: e.point, normal: e.normal }, (t) => {
  let n = Pn.peek();
  n?.hit === e && (Pn.value = {
    ...n,
    lux: t.lux ?? n.lux,
    lamps: t.lamps ?? n.lamps,
    done: t.done !== !1
  });
});
ha(() => {
  let e = ks.value;
  if (!e) return;
  let t = ys(() => fa(e)), n = null, o = !0, a = ha(() => {
    for (let [, l] of bs.all()) vs(l);
    n !== null && clearTimeout(n), o || (n = window.setTimeout(() => {
      t(), t = fa(e);
    }, 250)), o = !1;
  });
  return () => {
    t(), a(), n !== null && clearTimeout(n);
  };
});

// src/later/compare.tsx
import { before as ws, comparing as xs, digits as Ms, fitted as Ss, useEffect as Cs, useRef as $s, viewSize as Ls, wipeAt as Vn } from "./desk.js";
import { Fragment as Ps, jsx as En, jsxs as Vs } from "./desk.js";
function Ts() {
  let e = xs.value, t = ws.value, n = $s(null);
  if (Cs(() => {
    let i = n.current;
    !i || !t || (i.width = t.picture.width, i.height = t.picture.height, i.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [o] = Ls.value, a = Vn.value, l = Ss(t.picture.width, t.picture.height), r = Math.max(0, Math.min(1, (a * o - l.x) / (t.picture.width * l.scale))), s = (i) => {
    let m = i.currentTarget;
    if (i.stopPropagation(), i.type === "pointerdown") m.setPointerCapture(i.pointerId);
    else if (m.hasPointerCapture(i.pointerId)) {
      let c = m.parentElement.getBoundingClientRect();
      Vn.value = Math.max(0, Math.min(1, (i.clientX - c.left) / c.width));
    }
  }, p = (i) => {
    let m = { ArrowLeft: -0.02, ArrowRight: 0.02 }[i.key];
    m && (i.stopPropagation(), i.preventDefault(), Vn.value = Math.max(0, Math.min(1, a + m)));
  };
  return Vs(Ps, { children: [
    En(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * r}% 0 0)` : "none" }
      }
    ),
    En("span", { class: "tag left", children: "before" }),
    e === "wipe" && En(
      "div",
      {
        class: "wipe",
        "data-handle": "wipe",
        role: "slider",
        tabIndex: 0,
        "aria-label": "Wipe between before and now",
        "aria-valuemin": 0,
        "aria-valuemax": 100,
        "aria-valuenow": Math.round(a * 100),
        "aria-valuetext": `${Ms(a * 100)} % before`,
        style: { left: `${100 * a}%` },
        onPointerDown: s,
        onPointerMove: s,
        onKeyDown: p
      }
    )
  ] });
}

// src/later/inspector.tsx
import { act as bl, deselect as Nu, Icon as Qn, penless as Jn, selection as Du, signal as Gu } from "./desk.js";

// src/later/measure.tsx
import {
  add as Hs,
  deselect as La,
  digits as Ce,
  dot as Ns,
  edit as Gt,
  grids as Ds,
  Icon as Ta,
  length as Dt,
  maintained as He,
  maintenance as Gs,
  meters as Os,
  scale as Ws,
  selection as Pa,
  up as Ca
} from "./desk.js";

// src/later/figures.tsx
import { maintenance as ba, status as In } from "./desk.js";

// src/later/verdict.ts
function ga(e, t) {
  let n = ({ value: a, error: l, least: r }) => {
    let s = t ? 0 : l ?? 1 / 0;
    return a - s >= r ? "met" : a + s < r ? "missed" : "open";
  }, o = e.map(n);
  return o.includes("missed") ? "missed" : o.includes("open") ? "open" : "met";
}

// src/later/figures.tsx
import { jsx as Ma } from "./desk.js";
var va = () => In.value?.stage === "moving" || In.value?.stage === "loading", Es = () => va() || In.value?.stage === "refining", ya = { meter: 0.02, grid: 0.05 };
function ka(e, t, n) {
  return e == null || t == null || t > n * e || Es();
}
var Rt = ({ lux: e }) => ka(e?.[0], e?.[1], ya.meter), qt = ({ mean: e, error: t }) => ka(e, t, ya.grid), wa = (e, t) => va() ? "open" : ga(e, t === !0);
function Ft({ lux: e, target: t, done: n }) {
  if (!e || !t) return null;
  let o = ba.value;
  return wa([{ value: e[0] * o, error: e[1] == null ? null : e[1] * o, least: t }], n);
}
function Ht({ mean: e, error: t, uniformity: n, uniformity_error: o, target: a, done: l }) {
  if (!a || e == null || n == null) return null;
  let r = ba.value;
  return wa([
    { value: e * r, error: t == null ? null : t * r, least: a.lux },
    { value: n, error: o ?? null, least: a.uniformity }
  ], l);
}
var xa = {
  met: ["✓", "reaches its target"],
  missed: ["✗", "misses its target"],
  open: ["≈", "within its ± of the target: not decided yet"]
};
function An({ of: e }) {
  if (!e) return null;
  let [t, n] = xa[e];
  return Ma("b", { class: e, role: "img", "aria-label": n, title: n, children: t });
}
function Rn({ of: e }) {
  if (!e) return null;
  let [t, n] = xa[e];
  return Ma("p", { class: e, children: `${t} ${n[0].toUpperCase()}${n.slice(1)}` });
}

// src/later/parts.tsx
import { Field as Sa, Gesture as Is, Range as As, stroke as Rs, useRef as qs } from "./desk.js";
import { jsx as ue, jsxs as Nt } from "./desk.js";
function A({ title: e, note: t, children: n }) {
  return Nt("section", { class: "part", "aria-label": e, children: [
    Nt("h3", { children: [
      e,
      t && ue("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function K(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function P(e) {
  return Nt("label", { class: "line", children: [
    ue("span", { children: e.label }),
    ue(Sa, { ...e, label: e.name ?? e.label })
  ] });
}
function Fs(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function Q({ label: e, names: t, quantity: n, value: o, set: a, step: l, disabled: r }) {
  let s = t ?? ["X", "Y", "Z"];
  return Nt("div", { class: "line", role: "group", "aria-label": e, children: [
    ue("span", { children: e }),
    ue("span", { class: "triple", children: s.map((p, i) => ue(
      Sa,
      {
        label: `${e} ${p}`,
        quantity: n,
        value: o[i],
        text: Fs(o[i], n),
        step: l,
        disabled: r,
        set: (m) => a(i, m)
      },
      p
    )) })
  ] });
}
function qe({ label: e, name: t, value: n, text: o, patch: a, reset: l, notch: r, class: s, style: p, disabled: i }) {
  let m = qs(null), c = (u) => () => {
    m.current?.[u](), m.current = null;
  }, g = (u) => m.current ? m.current.set(a(u)) : Rs(e + t, t, a(u));
  return ue(
    As,
    {
      label: e,
      value: n,
      text: o,
      notch: r,
      class: s,
      gradient: p,
      disabled: i,
      begin: () => m.current = new Is(t),
      on: g,
      end: c("end"),
      cancel: c("cancel"),
      reset: l === void 0 ? void 0 : () => g(l)
    }
  );
}
function Fe({ value: e, label: t, set: n }) {
  return ue("span", { class: "field name-field", children: ue(
    "input",
    {
      type: "text",
      "aria-label": t,
      value: e,
      maxLength: 120,
      spellcheck: !1,
      onChange: (o) => {
        let a = o.currentTarget.value.trim();
        a && a !== e ? n(a) : o.currentTarget.value = e;
      },
      onKeyDown: (o) => {
        o.key === "Enter" && o.currentTarget.blur(), o.key === "Escape" && (o.stopPropagation(), o.currentTarget.value = e, o.currentTarget.blur());
      }
    }
  ) });
}
var ce = (e, t, n) => e.map((o, a) => a === t ? n(o) : o);

// src/later/measure.tsx
import { Fragment as qn, jsx as S, jsxs as X } from "./desk.js";
var Ks = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function Va() {
  let e = Pa.value?.ids[0], t = Os.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (o, a) => {
    let { lux: l, done: r, ...s } = { ...t, ...a };
    Gt(`${t.name}: ${o}`, { meters: { [e]: s } });
  };
  return X(qn, { children: [
    S("header", { class: "panel-head", children: S(Fe, { label: "Name of the meter", value: t.name, set: (o) => n("rename", { name: o }) }) }),
    S("p", { class: `crumbs ${Rt(t) ? "unsettled" : "known"}`, children: t.lux?.[1] != null ? `${He(t.lux[0])} ±${He(t.lux[1], !1)}` : "measuring" }),
    S("div", { class: "scroll", children: X(A, { title: "Meter", children: [
      X("label", { class: "line", children: [
        S("span", { children: "Measures" }),
        S("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (o) => n("kind", { kind: o.currentTarget.value }), children: Ks.map(([o, a]) => S("option", { value: o, children: a }, o)) })
      ] }),
      S(Q, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (o, a) => n("move", { point: ce(t.point, o, a) }) }),
      S(P, { label: "At least", quantity: "lux", step: 50, value: t.target ?? 0, set: (o) => n("target", { target: o(t.target ?? 0) || null }) }),
      S(Rn, { of: Ft(t) }),
      S(Q, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((o) => Math.round(o * 1e3) / 1e3), set: (o, a) => n("turn", { normal: ce(t.normal, o, a) }) }),
      X("button", { class: "plain full", onClick: () => {
        La(), Gt(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        S(Ta, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var $a = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function Ea() {
  let e = Pa.value?.ids[0], t = Ds.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This grid is gone." });
  let n = Gs.value, o = (i, m) => {
    let { name: c, corner: g, u, v: h, normal: v, columns: E, rows: H, border: ee, target: be } = { ...t, ...m };
    Gt(`${t.name}: ${i}`, { grids: { [e]: { name: c, corner: g, u, v: h, normal: v, columns: E, rows: H, border: ee, target: be } } });
  }, a = (i, m = t.border) => {
    let [c, g] = bn([gt(Dt(t.u), m), gt(Dt(t.v), m)]);
    o(i, { columns: c, rows: g, border: m });
  }, l = Ns(t.corner, Ca.value) - bt(), r = (i, m, c) => X(qn, { children: [
    S("dt", { children: i }),
    S("dd", { children: m == null ? "…" : c(m) })
  ] }), s = (i, m) => i == null ? "" : ` ±${m(i)}`, p = t.target ?? { lux: 500, uniformity: 0.6 };
  return X(qn, { children: [
    S("header", { class: "panel-head", children: S(Fe, { label: "Name of the grid", value: t.name, set: (i) => o("rename", { name: i }) }) }),
    X("p", { class: "crumbs", children: [
      Ce(Dt(t.u), 2),
      " × ",
      Ce(Dt(t.v), 2),
      " m, ",
      Ce(t.columns * t.rows),
      " points"
    ] }),
    X("div", { class: "scroll", children: [
      S(A, { title: "Figures", note: n === 1 ? "new" : `× ${Ce(n, 2)}`, children: X("dl", { class: `figures ${qt(t) ? "unsettled" : ""}`, children: [
        r("Ē", t.mean, (i) => He(i) + s(t.error, (m) => He(m, !1))),
        r("E min", t.min, (i) => He(i)),
        r("E max", t.max, (i) => He(i)),
        r("U₀ = min / mean", t.uniformity, (i) => Ce(i, 2) + s(t.uniformity_error, (m) => Ce(m, 2))),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => Ce(i, 2))
      ] }) }),
      X(A, { title: "Target", children: [
        S(Rn, { of: Ht(t) }),
        X("label", { class: "line", children: [
          S("span", { children: "Class" }),
          X("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let m = $a[Number(i.currentTarget.value)];
            o("target", { target: m ? { lux: m[1], uniformity: m[2] } : null });
          }, children: [
            S("option", { value: "", children: t.target ? "choose…" : "none" }),
            $a.map(([i, m, c], g) => X("option", { value: g, children: [
              i,
              ": ",
              m,
              " lx, U₀ ",
              c
            ] }, i)),
            S("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        S(P, { label: "Ē at least", quantity: "lux", step: 50, value: p.lux, set: (i) => o("target", { target: { ...p, lux: i(p.lux) } }) }),
        S(P, { label: "U₀ at least", quantity: "share", step: 0.05, value: p.uniformity, set: (i) => o("target", { target: { ...p, uniformity: i(p.uniformity) } }) })
      ] }),
      X(A, { title: "Area", children: [
        S(Q, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, m) => o("move", { corner: ce(t.corner, i, m) }) }),
        S(P, { label: "Height", name: "Height above the floor", quantity: "length", step: 0.01, value: l, set: (i) => o("height", { corner: Hs(t.corner, Ws(Ca.value, i(l) - l)) }) }),
        S(P, { label: "Border", quantity: "length", step: 0.05, value: t.border ?? 0, set: (i) => a("border", Math.max(0, i(t.border ?? 0))) }),
        S(P, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => o("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        S(P, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => o("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        S("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: () => a("standard spacing"), children: "Spacing of the standard" }),
        X("button", { class: "plain full", onClick: () => {
          La(), Gt(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          S(Ta, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as oe,
  chosenLamps as ou,
  dot as Gn,
  edit as Kt,
  format as Wa,
  groups as Bt,
  handles as Ot,
  Icon as De,
  lamps as Kn,
  layers as au,
  lumensOf as lu,
  normal as Ka,
  output as ru,
  percent as Wn,
  positionOf as Fa,
  selection as Ba,
  signal as Ua,
  spot as iu,
  sub as Ha,
  titleOf as Bn,
  tool as _a,
  toLevel as Na,
  toTravel as su,
  typeLevel as On,
  up as uu,
  Fade as cu,
  Field as pu,
  wantLevel as Da,
  compass as Xa,
  add as Ut,
  scale as Ge,
  length as mu,
  Range as du,
  strokeLevel as Ga,
  typeGroupLevel as hu,
  useRef as fu
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as Xs,
  digits as Aa,
  edit as Ys,
  fromHex as zs,
  hex as js,
  lamps as Ra,
  mired as $e,
  titleOf as Zs
} from "./desk.js";

// src/later/white.ts
import { css as Bs, mired as Fn } from "./desk.js";
function Us(e, t) {
  let [n, o] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * o,
    -0.969266 * n + 1.8760108 + 0.041556 * o,
    0.0556434 * n - 0.2040259 + 1.0572252 * o
  ].map((l) => Math.max(0, l));
}
function _s(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, o = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, o];
}
function Ia(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (a, l) => {
    let r = Fn(e) + (Fn(t) - Fn(e)) * l / (n - 1);
    return Bs(Us(..._s(1e6 / r)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as Nn, jsx as D, jsxs as he } from "./desk.js";
var at = 1800, Dn = 1e4, Qs = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], Js = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], eu = Ia(at, Dn), Hn = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(Ra.get(n).color) }]))
}), tu = (e) => {
  let t = 1e6 / ($e(at) + ($e(Dn) - $e(at)) * e);
  return Math.round(t / 10) * 10;
}, nu = (e) => ($e(e) - $e(at)) / ($e(Dn) - $e(at));
function qa() {
  let e = Xs.value, t = e.map((r) => Ra.get(r)?.color).filter((r) => r !== void 0);
  if (!t.length) return null;
  let n = K(t.map((r) => r.mode)), o = t[0], a = Zs(e), l = (r, s) => Ys(`${a}: ${r}`, Hn(e, s));
  return he(Nn, { children: [
    he("div", { class: "line", children: [
      D("span", { children: "Colour" }),
      D("div", { class: "segments", role: "group", "aria-label": "Colour by", children: Js.map(([r, s]) => D("button", { "aria-pressed": n === r, onClick: () => l(`colour by ${s}`, () => ({ mode: r })), children: s }, r)) })
    ] }),
    n === "kelvin" && he(Nn, { children: [
      he("div", { class: "line slide", children: [
        D("span", { children: "White" }),
        D(
          qe,
          {
            label: "Colour temperature",
            name: `${a}: white`,
            class: "mired",
            style: eu,
            value: nu(o.kelvin),
            text: `${Aa(o.kelvin)} kelvin`,
            patch: (r) => Hn(e, () => ({ mode: "kelvin", kelvin: tu(r) }))
          }
        )
      ] }),
      D(
        P,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: K(t.map((r) => r.kelvin)),
          step: 50,
          set: (r) => l("white", (s) => ({ mode: "kelvin", kelvin: r(s.kelvin) }))
        }
      ),
      D("div", { class: "whites", role: "group", "aria-label": "Whites", children: Qs.map(([r, s]) => D("button", { title: s, "aria-label": `${r} kelvin, ${s}`, onClick: () => l(`${r} K`, () => ({ mode: "kelvin", kelvin: r })), children: r }, r)) }),
      he("div", { class: "line slide", children: [
        D("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        D(
          qe,
          {
            label: "Tint, magenta to green",
            name: `${a}: tint`,
            class: "tints",
            value: (o.tint + 20) / 40,
            text: `${Aa(o.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (r) => Hn(e, () => ({ tint: Math.round((r * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      D(P, { label: "", name: "Tint, typed", quantity: "number", value: K(t.map((r) => r.tint)), step: 1, set: (r) => l("tint", (s) => ({ tint: Math.max(-50, Math.min(50, r(s.tint))) })) })
    ] }),
    n === "rgb" && he(Nn, { children: [
      he("label", { class: "line", children: [
        D("span", { children: "Colour" }),
        D("input", { type: "color", class: "pick", "aria-label": "Colour", value: js(o.rgb), onChange: (r) => l("colour", () => ({ mode: "rgb", rgb: zs(r.currentTarget.value) })) })
      ] }),
      D(
        Q,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: o.rgb,
          set: (r, s) => l("colour", (p) => ({ rgb: p.rgb.map((i, m) => m === r ? Math.max(0, s(i)) : i) }))
        }
      )
    ] }),
    n === "xy" && he("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      D("span", { children: "x, y" }),
      D("span", { class: "triple", children: [0, 1].map((r) => D(
        P,
        {
          label: "xy"[r],
          quantity: "number",
          step: 1e-3,
          value: K(t.map((s) => s.xy[r])),
          set: (s) => l("chromaticity", (p) => ({ xy: p.xy.map((i, m) => m === r ? Math.max(0.01, Math.min(0.9, s(i))) : i) }))
        },
        r
      )) })
    ] }),
    n === null && D("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as Un, jsx as y, jsxs as G } from "./desk.js";
var Ne = Ua(1), Wt = Ua([1, 0, 0]), gu = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], _t = 180 / Math.PI;
function Oa(e, t) {
  let { right: n, ahead: o } = Xa(t), a = -Gn(e, t);
  return [Math.atan2(Gn(e, n), Gn(e, o)) * _t, Math.asin(Math.max(-1, Math.min(1, a))) * _t];
}
function bu(e, t, n) {
  let { right: o, ahead: a } = Xa(n), [l, r] = [e / _t, t / _t], s = Ut(Ge(o, Math.sin(l)), Ge(a, Math.cos(l)));
  return Ka(Ut(Ge(s, Math.cos(r)), Ge(n, -Math.sin(r))));
}
function vu({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction), o = Ba.value?.kind === "group";
  return G("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    G("button", { "aria-pressed": _a.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => oe("aim"), children: [
      y(De, { name: "aim" }),
      "Aim"
    ] }),
    y("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => oe("solo"), children: y(De, { name: "solo" }) }),
    y("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => oe("from-lamp"), children: y(De, { name: "eye" }) }),
    y("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => oe("frame"), children: y(De, { name: "frame" }) }),
    y("span", { class: "gap" }),
    $t() === null && y("button", { title: "Group (Ctrl+G): one master for all of them", onClick: () => oe("group"), children: "Group" }),
    Lt() === null && y("button", { title: o ? "Dissolve the group (Ctrl+Shift+G): its lamps stay" : "Take out of the group (Ctrl+Shift+G)", onClick: () => oe("ungroup"), children: o ? "Dissolve" : "Take out" }),
    y("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => oe("park"), children: "Park" }),
    y("button", { class: "icon", "aria-label": `Remove ${Bn(e)}`, title: "Remove (Del)", onClick: () => oe("remove"), children: y(De, { name: "bin" }) })
  ] });
}
function yu({ ids: e, all: t }) {
  let n = K(t.map((r) => r.level)), o = lu(e), a = t.every((r) => r.free), l = e[e.length - 1];
  return G(A, { title: "Light", note: a ? "re-mix" : "re-trace", children: [
    G("div", { class: "line slide", children: [
      y("span", { children: "Level" }),
      y(ku, { id: l })
    ] }),
    G("label", { class: "line", children: [
      y("span", {}),
      y(
        pu,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: K(t.map((r) => r.flux)) ?? void 0,
          step: 0.01,
          set: (r) => On(e, r),
          open: Da.value,
          opened: () => Da.value = "",
          id: "level"
        }
      )
    ] }),
    y(
      P,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (r) => On(e, (s, p) => r(s * p) / p)
      }
    ),
    G("div", { class: "line", children: [
      y("span", { children: "Stops" }),
      y("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: gu.map(([r, s]) => y("button", { "aria-label": `${s} stop`, onClick: () => On(e, (p) => Math.min(1e3, p * 2 ** r)), children: s }, s)) })
    ] }),
    G("p", { class: "sum", children: [
      Wa(o, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (Bt.get(t[0].group)?.level ?? 1) !== 1 && ` (${Wn(t[0].level)} % × ${Wn(Bt.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    y(qa, {})
  ] });
}
function ku({ id: e }) {
  let t = fu(null), n = Kn.get(e);
  if (!n) return null;
  let o = { kind: "lamp", id: e }, a = (l) => () => {
    t.current?.[l](), t.current = null;
  };
  return y(
    du,
    {
      label: "Level",
      value: su(n.level),
      text: `${Wn(n.level)} %, ${Wa(n.flux * ru(n), "flux")}`,
      begin: () => t.current = new cu(o),
      on: (l) => t.current ? t.current.to(Na(l)) : Ga(o, Na(l)),
      end: a("end"),
      cancel: a("cancel"),
      reset: () => Ga(o, 1)
    }
  );
}
function lt(e, t, n) {
  let o = {};
  for (let a of e) {
    let l = Kn.get(a), r = n(l.place ?? {}, l);
    r && (o[a] = { place: r });
  }
  Object.keys(o).length && Kt(`${Bn(e)}: ${t}`, { lamps: o });
}
function wu({ ids: e, all: t }) {
  let n = (a) => K(t.map((l) => l.place?.[a] ?? null)), o = (a) => t.some((l) => l.place?.[a] != null);
  return !o("outer") && !o("radius") ? null : G(A, { title: "Beam", note: "re-trace", children: [
    o("outer") && G(Un, { children: [
      y(P, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (a) => lt(e, "beam", (l) => l.outer == null ? null : { inner: Math.max(0.1, Math.min(l.outer, a(l.inner ?? l.outer))) }) }),
      y(P, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (a) => lt(e, "beam", (l) => {
        if (l.outer == null) return null;
        let r = Math.max(0.2, Math.min(179, a(l.outer)));
        return { outer: r, inner: Math.min(l.inner ?? r, r) };
      }) })
    ] }),
    o("radius") && y(P, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (a) => lt(e, "radius", (l) => l.radius == null ? null : { radius: Math.max(1e-3, a(l.radius)) }) })
  ] });
}
function xu({ ids: e, all: t }) {
  let n = t.filter((c) => Fa(c) !== null);
  if (!n.length) return null;
  let o = n.map((c) => Fa(c)), a = (c, g) => K(g.map((u) => Math.round(u[c] * 1e4) / 1e4)), l = t.filter((c) => c.place?.direction), r = uu.value, s = l.map((c) => Oa(c.place?.direction, r).map((g) => Math.round(g * 10) / 10)), p = t.map((c) => c.place?.aim).filter((c) => !!c), i = (c, g) => {
    let u = Je(e), h = {};
    for (let [v, E] of u) {
      let H = [0, 0, 0];
      H[c] = g(E[c]) - E[c], Object.assign(h, Qe([v], H, u).lamps);
    }
    Kt(`Move ${Bn(e)}`, { lamps: h });
  }, m = (c, g) => lt(e, c ? "tilt" : "pan", (u) => {
    if (!u.direction) return null;
    let h = Oa(u.direction, r);
    h[c] = g(h[c]);
    let v = bu(h[0], Math.max(-90, Math.min(90, h[1])), r), E = u.aim && u.position ? mu(Ha(u.aim, u.position)) : 0;
    return { direction: v, ...E && u.position ? { aim: Ut(u.position, Ge(v, E)) } : {} };
  });
  return G(A, { title: "Place", note: "re-trace", children: [
    y(Q, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => a(c, o)), set: i }),
    l.length > 0 && G(Un, { children: [
      y(P, { label: "Pan", quantity: "angle", step: 1, value: K(s.map((c) => c[0])), set: (c) => m(0, c) }),
      y(P, { label: "Tilt", quantity: "angle", step: 1, value: K(s.map((c) => c[1])), set: (c) => m(1, c) }),
      y(
        Q,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: p.length ? [0, 1, 2].map((c) => a(c, p)) : [NaN, NaN, NaN],
          set: (c, g) => lt(e, "aim", (u) => {
            if (!u.direction || !u.position) return null;
            let h = ce(u.aim ?? Ut(u.position, Ge(u.direction, 2)), c, g);
            return { aim: h, direction: Ka(Ha(h, u.position)) };
          })
        }
      )
    ] }),
    G("div", { class: "line", children: [
      y("span", { children: "Handles" }),
      G("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        y("button", { "aria-pressed": Ot.value === "move", onClick: () => Ot.value = "move", children: "Move" }),
        y("button", { "aria-pressed": Ot.value === "turn", onClick: () => Ot.value = "turn", children: "Turn" })
      ] })
    ] }),
    y("button", { class: "plain full", "aria-pressed": _a.value === "place", onClick: () => oe("place"), children: "Put on a surface by pointing" }),
    l.length > 0 && iu.value && y("button", { class: "plain full", onClick: () => oe("aim-here"), children: "Aim at the last point" })
  ] });
}
function Mu({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : G(A, { title: "Copies along a line", children: [
    y(P, { label: "How many", quantity: "number", step: 1, value: Ne.value, set: (n) => Ne.value = Math.max(1, Math.min(100, Math.round(n(Ne.value)))) }),
    y(Q, { label: "Step", quantity: "length", step: 0.05, value: Wt.value, set: (n, o) => Wt.value = ce(Wt.value, n, o) }),
    G("button", { class: "plain full", onClick: () => Mt(e, Ne.value, Wt.value), children: [
      y(De, { name: "copy" }),
      Ne.value === 1 ? "One copy" : `${Ne.value} copies`
    ] })
  ] });
}
function Ya() {
  let e = ou.value, t = e.map((s) => Kn.get(s)).filter((s) => !!s);
  if (!t.length) return y("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, o = n && Bt.get(n.group), a = Ba.value, l = a?.kind === "group" && a.ids.length === 1 ? Bt.get(a.ids[0]) : void 0, r = n?.layer != null ? au.value[n.layer] : void 0;
  return G(Un, { children: [
    y("header", { class: "panel-head", children: l && a ? y(Fe, { label: "Name of the group", value: l.name, set: (s) => Kt(`Rename ${l.name}`, { groups: { [a.ids[0]]: { name: s } } }) }) : n ? y(Fe, { label: "Name of the lamp", value: n.name, set: (s) => Kt(`Rename ${n.name}`, { lamps: { [e[0]]: { name: s } } }) }) : G("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    y("p", { class: "crumbs", children: n ? `${n.kind}${o && o.lamps.length > 1 ? ` ▸ ${o.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((s) => s.on).length} of ${t.length} on` }),
    G("div", { class: "scroll", children: [
      y(vu, { ids: e, all: t }),
      l && a && y(A, { title: "Group", note: "re-mix", children: y(P, { label: "Master", name: "Master of the group", quantity: "level", step: 0.01, value: l.level, set: (s) => hu(a.ids[0], s) }) }),
      y(yu, { ids: e, all: t }),
      y(A, { title: "Photometry", children: y("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      y(wu, { ids: e, all: t }),
      y(xu, { ids: e, all: t }),
      y(Mu, { ids: e, all: t }),
      y("p", { class: "cost", children: t.every((s) => s.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as _n,
  candles as Xt,
  command as Su,
  digits as zt,
  edit as za,
  Field as ja,
  filterOf as el,
  go as Cu,
  history as $u,
  hovered as Za,
  Icon as jt,
  layers as Lu,
  lookOnly as Qa,
  maintenance as Oe,
  materials as Tu,
  percent as Pu,
  scene as Vu,
  select as tl,
  signal as Eu,
  singleKeys as Ja,
  sub as Iu,
  things as Au,
  travel as Yt,
  Virtual as nl,
  workPlane as Xn
} from "./desk.js";
import { Fragment as Ru, jsx as M, jsxs as V } from "./desk.js";
function ol() {
  let e = Vu.value;
  if (!e) return null;
  let t = Iu(e.bounds[1], e.bounds[0]);
  return V(Ru, { children: [
    V(A, { title: "Room", children: [
      V("p", { children: [
        t.map((n) => zt(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${zt(e.triangles)} triangles` : ""
      ] }),
      M("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && M("ul", { class: "buttons", children: e.cameras.map((n, o) => M("li", { children: M("button", { onClick: () => Cu(n, n.name ?? "camera"), children: n.name || `Camera ${o + 1}` }) }, o)) }),
      e.warnings.length > 0 && V("details", { children: [
        V("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        M("ul", { class: "remarks", children: e.warnings.map((n) => M("li", { children: n }, n)) })
      ] })
    ] }),
    V(A, { title: "Figures", children: [
      V("label", { class: "line", children: [
        M("span", { children: "Maintenance" }),
        M(ja, { label: "Maintenance factor", quantity: "share", value: Oe.value, step: 0.05, set: (n) => Oe.value = Math.max(0.1, Math.min(1, n(Oe.value))) })
      ] }),
      V("p", { class: "quiet", children: [
        Oe.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Oe.value === 1 && M("button", { class: "plain", onClick: () => Oe.value = 0.8, children: "0.80" })
      ] }),
      V("label", { class: "line", children: [
        M("span", { children: "Work plane" }),
        M(ja, { label: "Work plane above the floor", quantity: "length", value: Xn.value, step: 0.05, set: (n) => Xn.value = Math.max(0, Math.min(3, n(Xn.value))) })
      ] }),
      V("div", { class: "line", children: [
        M("span", { children: "Unit" }),
        V("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          M("button", { "aria-pressed": Xt.value === "lx", onClick: () => Xt.value = "lx", children: "lx, cd/m²" }),
          M("button", { "aria-pressed": Xt.value === "fc", onClick: () => Xt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    M(A, { title: "Layers of light", children: M("ul", { class: "layers", children: Lu.value.map((n, o) => V("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      M("i", { class: "dot", "aria-hidden": "true" }),
      M("span", { children: n.name || `layer ${o + 1}` }),
      M("small", { children: n.held ? "held" : Pu(n.of ? n.batches / n.of : 0) + " %" })
    ] }, o)) }) }),
    V(A, { title: "Hands", children: [
      V("div", { class: "line", children: [
        M("span", { children: "Faders" }),
        V("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          M("button", { "aria-pressed": Yt.value === "square", onClick: () => Yt.value = "square", children: "Square law" }),
          M("button", { "aria-pressed": Yt.value === "linear", onClick: () => Yt.value = "linear", children: "Even" })
        ] })
      ] }),
      V("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: Ja.value, onChange: (n) => Ja.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      V("label", { class: "check", children: [
        M("input", { type: "checkbox", checked: Qa.value, onChange: (n) => Qa.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var Zt = Eu("");
function al({ label: e }) {
  return M("span", { class: "field filter", children: M("input", { type: "text", "aria-label": e, placeholder: "Filter", value: Zt.value, onInput: (t) => Zt.value = t.currentTarget.value }) });
}
function ll() {
  let e = el(Au, Zt.value);
  return V("div", { class: "listing", children: [
    M(al, { label: "Filter things" }),
    M(
      nl,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, o] = e[t];
          return V("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => Za.value = { kind: "thing", id: n }, onPointerLeave: () => Za.value = null, children: [
            M("button", { class: "icon", "aria-pressed": !o.hidden, "aria-label": `${o.name} shown`, onClick: () => za(`${o.hidden ? "Show" : "Hide"} ${o.name}`, { things: { [n]: { hidden: !o.hidden } } }), children: M(jt, { name: o.hidden ? "eye-off" : "eye" }) }),
            M("button", { class: "row-name", onClick: () => tl("thing", n), children: M("span", { children: o.name }) }),
            M("button", { class: "icon", "aria-pressed": o.locked, "aria-label": `${o.name} locked`, onClick: () => za(`${o.locked ? "Unlock" : "Lock"} ${o.name}`, { things: { [n]: { locked: !o.locked } } }), children: M(jt, { name: o.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function rl() {
  let e = el(Tu, Zt.value);
  return V("div", { class: "listing", children: [
    M(al, { label: "Filter materials" }),
    M(
      nl,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, o] = e[t];
          return V("div", { class: "sheet-row material", role: "listitem", children: [
            M("button", { class: "row-name", onClick: () => tl("material", n), children: M("span", { children: o.name }) }),
            V("small", { children: [
              o.kind,
              o.reflectance != null ? ` · ρ ${zt(o.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function il() {
  let e = $u.value;
  return V(A, { title: "History", children: [
    V("p", { children: [
      e.steps === 1 ? "One step" : `${zt(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => _n("undo"), children: [
      M(jt, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => _n("redo"), children: [
      M(jt, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    M("button", { class: "plain full", onClick: () => _n("save"), children: "Save a version with a name…" }),
    M("button", { class: "plain full", onClick: () => Su({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as Yn,
  edit as pl,
  fromHex as qu,
  hex as Fu,
  Icon as sl,
  materials as ml,
  middle as ul,
  select as dl,
  selection as hl,
  things as zn
} from "./desk.js";
import { Fragment as Zn, jsx as L, jsxs as j } from "./desk.js";
var jn = 180 / Math.PI;
function cl(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * jn : 0;
}
function Hu(e, t) {
  let n = [0, 0, 0, Math.cos(t / jn / 2)];
  return n[e] = Math.sin(t / jn / 2), n;
}
function fl() {
  let e = (hl.value?.ids ?? []).filter((p) => zn.get(p)), t = e.map((p) => zn.get(p));
  if (!t.length) return L("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], o = e.length === 1 ? n.name : `${e.length} things`, a = t.some((p) => p.locked), l = (p, i) => pl(`${o}: ${p}`, { things: Object.fromEntries(e.map((m, c) => [m, i(t[c])])) }), r = t.map((p) => p.place?.position ?? (p.box ? ul(p.box) : [0, 0, 0])), s = n.box ? [0, 1, 2].map((p) => n.box[1][p] - n.box[0][p]) : null;
  return j(Zn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: o }) }),
    s && j("p", { class: "crumbs", children: [
      s.map((p) => Yn(p, 2)).join(" × "),
      " m"
    ] }),
    j("div", { class: "scroll", children: [
      j("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        j("button", { "aria-pressed": t.every((p) => p.hidden), onClick: () => l(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          L(sl, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        j("button", { "aria-pressed": a, onClick: () => l(a ? "unlock" : "lock", () => ({ locked: !a })), children: [
          L(sl, { name: a ? "lock" : "unlock" }),
          a ? "Locked" : "Lock"
        ] })
      ] }),
      j(A, { title: "Place", note: "re-trace", children: [
        a && L("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        L(
          Q,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: a,
            value: [0, 1, 2].map((p) => K(r.map((i) => Math.round(i[p] * 1e4) / 1e4))),
            set: (p, i) => l("move", (m) => ({ place: { position: ce(m.place?.position ?? ul(m.box), p, i) } }))
          }
        ),
        [0, 1, 2].map((p) => L(
          P,
          {
            label: `Turn ${"XYZ"[p]}`,
            quantity: "angle",
            step: 5,
            disabled: a,
            value: K(t.map((i) => Math.round(cl(i.place?.rotation, p) * 10) / 10)),
            set: (i) => l("turn", (m) => ({ place: { rotation: Hu(p, i(cl(m.place?.rotation, p))) } }))
          },
          p
        )),
        L(
          P,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: a,
            value: K(t.map((p) => p.place?.scale ?? 1)),
            set: (p) => l("scale", (i) => ({ place: { scale: Math.max(1e-3, p(i.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      L(A, { title: "Materials", children: L("ul", { class: "buttons", children: n.materials.map((p) => L("li", { children: L("button", { onClick: () => dl("material", p), children: ml.get(p)?.name ?? `material ${p}` }) }, p)) }) })
    ] })
  ] });
}
function gl() {
  let e = hl.value?.ids[0], t = ml.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This material is gone." });
  let n = (i, m) => pl(`${t.name}: ${i}`, { materials: { [e]: m } }), o = t.transmittance ? "transmittance" : "color", a = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], r = ((i) => 0.2126 * i[0] + 0.7152 * i[1] + 0.0722 * i[2])(a), s = (i) => a.map((m) => Math.max(0, Math.min(1, r > 1e-4 ? m / r * i : i))), p = (i, m) => t[m] != null && j(Zn, { children: [
    j("div", { class: "line slide", children: [
      L("span", { children: i }),
      L(qe, { label: i, name: `${t.name}: ${i.toLowerCase()}`, value: t[m], text: Yn(t[m], 2), patch: (c) => ({ materials: { [e]: { [m]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    L(P, { label: "", name: `${i}, typed`, quantity: "share", step: 0.01, value: t[m], set: (c) => n(i.toLowerCase(), { [m]: Math.max(0, Math.min(1, c(t[m]))) }) })
  ] });
  return j(Zn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: t.name }) }),
    L("p", { class: "crumbs", children: t.kind }),
    j("div", { class: "scroll", children: [
      j(A, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        j("div", { class: "line slide", children: [
          L("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          L(qe, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: r, text: Yn(r, 2), patch: (i) => ({ materials: { [e]: { [o]: s(Math.min(0.95, i)) } } }) })
        ] }),
        L(P, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(r * 1e3) / 1e3, set: (i) => n("reflectance", { [o]: s(Math.min(0.98, i(r))) }) }),
        j("label", { class: "line", children: [
          L("span", { children: "Colour" }),
          L("input", { type: "color", class: "pick", "aria-label": "Colour", value: Fu(a), onChange: (i) => n("colour", { [o]: qu(i.currentTarget.value) }) })
        ] }),
        p("Roughness", "roughness"),
        p("Gloss", "specular")
      ] }),
      L(A, { title: "On", children: L("ul", { class: "buttons", children: zn.all().filter(([, i]) => i.materials.includes(e)).slice(0, 40).map(([i, m]) => L("li", { children: L("button", { onClick: () => dl("thing", i), children: m.name }) }, i)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as vl, jsx as N, jsxs as Qt } from "./desk.js";
var rt = ["Scene", "Things", "Materials", "History"], fe = Gu("Scene");
function Ou() {
  let e = { Scene: ol, Things: ll, Materials: rl, History: il }[fe.value];
  return Qt(vl, { children: [
    N("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let o = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      o && (n.preventDefault(), n.stopPropagation(), fe.value = rt[(rt.indexOf(fe.value) + o + rt.length) % rt.length], document.getElementById(`tab-${fe.value}`)?.focus());
    }, children: rt.map((n) => N("button", { id: `tab-${n}`, role: "tab", "aria-selected": fe.value === n, "aria-controls": "tab-panel", tabIndex: fe.value === n ? 0 : -1, onClick: () => fe.value = n, children: n }, n)) }),
    N("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${fe.value}`, tabIndex: 0, children: N(e, {}) })
  ] });
}
function Wu() {
  let e = Du.value;
  return e ? Qt(vl, { children: [
    Qt("nav", { class: "chooser", "aria-label": "Selection", children: [
      N("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => bl("previous"), children: N(Qn, { name: "back" }) }),
      N("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => bl("next"), children: N(Qn, { name: "forth" }) }),
      N("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      N("span", { class: "gap" }),
      N("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: Nu, children: N(Qn, { name: "close" }) })
    ] }),
    Jn.value && N("p", { class: "penless", children: Jn.value }),
    Qt("fieldset", { class: "editing", disabled: Jn.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && N(Ya, {}),
      e.kind === "thing" && N(fl, {}),
      e.kind === "material" && N(gl, {}),
      e.kind === "meter" && N(Va, {}),
      e.kind === "grid" && N(Ea, {})
    ] })
  ] }) : N(Ou, {});
}

// src/later/legend.tsx
import { asked as Ku, candles as Bu, DEFAULT_FALSE as Uu, display as _u, Field as Xu, looks as Yu, show as kl, three as zu, useRef as ju } from "./desk.js";
import { Fragment as ec, jsx as Y, jsxs as Le } from "./desk.js";
var eo = [1, 2, 5];
function Zu(e, t, n) {
  let o = [];
  if (n === "linear") {
    let a = (t - e) / 5, l = 10 ** Math.floor(Math.log10(a)), r = l * (eo.find((s) => s * l >= a) ?? 10);
    for (let s = Math.ceil(e / r) * r; s <= t * 1.0001; s += r) o.push(s);
    return o;
  }
  for (let a = Math.floor(Math.log10(e)); a <= Math.ceil(Math.log10(t)); a++)
    for (let l of eo) {
      let r = l * 10 ** a;
      r >= e * 0.999 && r <= t * 1.001 && o.push(r);
    }
  return o.length > 10 ? o.filter((a) => Math.abs(Math.log10(a) % 1) < 1e-6) : o;
}
function Qu(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var ae = (e, t) => {
  let n = Ku({ ...e, ...t });
  n.against != null && (n = go(n)), n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && kl({ false_color: n });
};
function yl(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, o = (n % 3 + 3) % 3;
  return eo[o] * 10 ** ((n - o) / 3);
}
function Ju() {
  let e = _u.value.false_color, t = ju(null);
  if (!e) return null;
  let n = Bu.value === "fc", o = e.quantity === "difference", a = e.quantity !== "luminance", l = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", r = n ? a ? 1 / 10.7639 : 0.2919 : 1, s = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, p = e.ticks ?? Zu(e.low, e.high, e.scale).map((u) => [u, Qu(u, e)]), i = (u) => {
    let h = String(Number(u.toPrecision(2)));
    return o ? h.replace("-", "−").replace(/^(?=[1-9]|0\.)/, "+") : h;
  }, m = (u, h, v) => o ? { high: yl(Math.abs(h), u === "low" ? -v : v) } : { [u]: yl(h, v) }, c = (u) => ({
    onPointerDown: (h) => {
      h.currentTarget.setPointerCapture(h.pointerId), t.current = { y: h.clientY, end: u, from: e[u] };
    },
    onPointerMove: (h) => {
      let v = t.current;
      v?.end === u && ae(e, m(u, v.from, Math.round((v.y - h.clientY) / 14)));
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (h) => {
      let v = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[h.key];
      v && (h.preventDefault(), h.stopPropagation(), ae(e, m(u, e[u], v)));
    }
  }), g = ({ end: u }) => Le("div", { class: "end", children: [
    Y(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": u === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[u],
        "aria-valuemin": o ? -1e6 : 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${zu(e[u] * r)} ${l}`,
        ...c(u)
      }
    ),
    o && u === "low" ? Y("output", { children: i(e.low * r) }) : Y(
      Xu,
      {
        label: u === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[u] * r).toPrecision(3)),
        set: (h) => ae(e, { [u]: h(e[u] * r) / r })
      }
    )
  ] });
  return Le("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    Le("header", { children: [
      Y(
        "button",
        {
          "aria-label": `${l}: ${o ? "difference" : e.quantity}, change`,
          onClick: () => o ? kl({ false_color: Uu }) : ae(e, { quantity: a ? "luminance" : "illuminance" }),
          children: o ? `Δ ${l}` : l
        }
      ),
      !o && Y("button", { "aria-pressed": e.scale === "log", onClick: () => ae(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      Y("button", { "aria-pressed": e.lines, onClick: () => ae(e, { lines: !e.lines }), children: "lines" })
    ] }),
    o && Le("p", { class: "quiet", title: e.exact === !1 ? "Lamps that differ in the look share a layer of light: what is shown of them is their mean." : void 0, children: [
      e.exact === !1 ? "≈ " : "",
      "now − ",
      Yu.get(e.against)?.name ?? "look"
    ] }),
    Y(g, { end: "high" }),
    Y("div", { class: "scale", style: { background: s }, children: p.map(([u, h]) => Y("span", { style: { bottom: `${100 * h}%` }, children: i(u * r) }, u)) }),
    Y(g, { end: "low" }),
    Le("footer", { children: [
      o ? [50, 500].map((u) => Le("button", { onClick: () => ae(e, { high: u }), children: [
        "±",
        u
      ] }, u)) : Le(ec, { children: [
        Y("button", { onClick: () => ae(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
        Y("button", { onClick: () => ae(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" })
      ] }),
      Y(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (u) => ae(e, { palette: u.currentTarget.value }),
          children: e.palettes?.map((u) => Y("option", { children: u }, u)) ?? Y("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as oo,
  act as Ll,
  ask as pc,
  command as mc,
  copyText as dc,
  digits as hc,
  go as fc,
  hear as gc,
  lamps as bc,
  say as nn,
  select as vc,
  send as en,
  sheet as st,
  shown as yc,
  signal as ut,
  useEffect as ao,
  useLayoutEffect as kc,
  useRef as on,
  walkNames as wc,
  whyNotTo as xc
} from "./desk.js";

// src/later/csv.ts
import { gridPoint as tc, grids as nc, maintenance as oc, meters as ac, scene as wl } from "./desk.js";
var lc = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function rc() {
  let e = oc.peek(), t = [["scene", wl.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of ac.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of nc.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let o = { mean: n.mean, min: n.min, max: n.max };
    for (let [a, l] of Object.entries(o)) t.push([a, l == null ? null : l * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((a, l) => {
      let r = tc(n, l % n.columns, Math.floor(l / n.columns));
      t.push([...r.map((s) => s.toFixed(3)), a === null ? null : a * e]);
    });
  }
  return t.map((n) => n.map(lc).join(",")).join(`\r
`) + `\r
`;
}
function to(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function xl() {
  let e = URL.createObjectURL(new Blob([rc()], { type: "text/csv" }));
  to(`${wl.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var Cl = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], Jt = new Uint8Array(512), no = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  Jt[e] = Jt[e + 255] = t, no[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var Ml = (e, t) => e && t ? Jt[no[e] + no[t]] : 0;
function ic(e, t) {
  let n = [1];
  for (let a = 0; a < t; a++) {
    let l = new Array(n.length + 1).fill(0);
    n.forEach((r, s) => {
      l[s] ^= r, l[s + 1] ^= Ml(r, Jt[a]);
    }), n = l;
  }
  let o = [...e, ...new Array(t).fill(0)];
  for (let a = 0; a < e.length; a++) {
    let l = o[a];
    l && n.forEach((r, s) => o[a + s] ^= Ml(r, l));
  }
  return o.slice(e.length);
}
function sc(e, t) {
  let [n, o, a] = Cl[t - 1], l = [], r = (g, u) => {
    for (let h = u - 1; h >= 0; h--) l.push(g >> h & 1);
  };
  for (r(4, 4), r(e.length, 8), e.forEach((g) => r(g, 8)), r(0, Math.min(4, n * 8 - l.length)); l.length % 8; ) l.push(0);
  let s = [];
  for (let g = 0; g < l.length; g += 8) s.push(parseInt(l.slice(g, g + 8).join(""), 2));
  for (let g = 236; s.length < n; g ^= 253) s.push(g);
  let p = n / a, i = Array.from({ length: a }, (g, u) => s.slice(u * p, (u + 1) * p)), m = i.map((g) => ic(g, o)), c = (g) => g[0].flatMap((u, h) => g.map((v) => v[h]));
  return [...c(i), ...c(m)];
}
var uc = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function cc(e) {
  let t = 8 | e, n = t << 10;
  for (let o = 14; o >= 10; o--) n >> o & 1 && (n ^= 1335 << o - 10);
  return (t << 10 | n) ^ 21522;
}
function Sl(e) {
  let t = e.length, n = 0, o = 0;
  for (let a of [!1, !0])
    for (let l = 0; l < t; l++) {
      let r = Array.from({ length: t }, (i, m) => a ? e[m][l] : e[l][m]), s = 1;
      for (let i = 1; i <= t; i++)
        i < t && r[i] === r[i - 1] ? s++ : (s >= 5 && (n += s - 2), s = 1);
      let p = r.map(Number).join("");
      for (let i = 0; i + 11 <= t; i++) {
        let m = p.slice(i, i + 11);
        (m === "10111010000" || m === "00001011101") && (n += 40);
      }
    }
  for (let a = 0; a < t; a++)
    for (let l = 0; l < t; l++)
      e[a][l] && o++, l && a && e[a][l] === e[a - 1][l] && e[a][l] === e[a][l - 1] && e[a][l] === e[a - 1][l - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(o * 20 / (t * t) - 10));
}
function $l(e) {
  let t = [...new TextEncoder().encode(e)], n = Cl.findIndex(([u]) => t.length + 2 <= u) + 1;
  if (!n) return null;
  let o = 17 + 4 * n, a = Array.from({ length: o }, () => new Array(o).fill(!1)), l = Array.from({ length: o }, () => new Array(o).fill(!1)), r = (u, h, v) => {
    u < 0 || h < 0 || u >= o || h >= o || (a[h][u] = v, l[h][u] = !0);
  };
  for (let u = 0; u < o; u++)
    r(u, 6, u % 2 === 0), r(6, u, u % 2 === 0);
  for (let [u, h] of [[3, 3], [o - 4, 3], [3, o - 4]])
    for (let v = -4; v <= 4; v++)
      for (let E = -4; E <= 4; E++) {
        let H = Math.max(Math.abs(E), Math.abs(v));
        r(u + E, h + v, H !== 2 && H !== 4);
      }
  if (n > 1) {
    let u = o - 7;
    for (let h = -2; h <= 2; h++) for (let v = -2; v <= 2; v++) r(u + v, u + h, Math.max(Math.abs(v), Math.abs(h)) !== 1);
  }
  let s = (u) => {
    let h = cc(u);
    for (let v = 0; v < 15; v++) {
      let E = (h >> v & 1) === 1, H = v < 6 ? v : v < 8 ? v + 1 : o - 15 + v;
      r(8, H, E), r(v < 8 ? o - 1 - v : v < 9 ? 7 : 14 - v, 8, E);
    }
    r(8, o - 8, !0);
  };
  s(0);
  let p = sc(t, n), i = 0;
  for (let u = o - 1; u > 0; u -= 2) {
    u === 6 && (u = 5);
    for (let h = 0; h < o; h++)
      for (let v of [u, u - 1]) {
        let H = (u + 1 & 2) === 0 ? o - 1 - h : h;
        l[H][v] || (a[H][v] = i < p.length * 8 && (p[i >> 3] >> 7 - (i & 7) & 1) === 1, i++);
      }
  }
  let m = (u) => (s(u), a.map((h, v) => h.map((E, H) => E !== (!l[v][H] && uc[u](H, v))))), c = m(0), g = Sl(c);
  for (let u = 1; u < 8; u++) {
    let h = m(u), v = Sl(h);
    v < g && ([c, g] = [h, v]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as Ic, jsx as f, jsxs as T } from "./desk.js";
function ct({ title: e, wide: t, children: n }) {
  let o = on(null);
  kc(() => {
    let l = o.current, r = document.activeElement;
    return l.open || l.showModal(), () => r?.focus();
  }, []);
  let a = () => st.value = null;
  return f(
    "dialog",
    {
      ref: o,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: a,
      onClick: (l) => l.target === o.current && a(),
      children: T("div", { class: "sheet-body", children: [
        T("header", { children: [
          f("h2", { children: e }),
          f("span", { class: "gap" }),
          f("button", { onClick: a, children: "Close" })
        ] }),
        n
      ] })
    }
  );
}
var Mc = [
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
function Sc() {
  let e = [...new Set(oo().map((t) => t.group))];
  return f(ct, { title: "All keys", wide: !0, children: T("div", { class: "help", children: [
    T("table", { children: [
      f("caption", { class: "spoken", children: "By hand" }),
      f("thead", { children: T("tr", { children: [
        f("th", { scope: "col", children: "What" }),
        f("th", { scope: "col", children: "Mouse" }),
        f("th", { scope: "col", children: "Keys, in the view" }),
        f("th", { scope: "col", children: "Fingers" })
      ] }) }),
      f("tbody", { children: Mc.map(([t, n, o, a]) => T("tr", { children: [
        f("th", { scope: "row", children: t }),
        f("td", { children: n }),
        f("td", { children: o.replace("walking keys", wc.value) }),
        f("td", { children: a })
      ] }, t)) })
    ] }),
    T("div", { class: "columns", children: [
      e.map((t) => T("section", { children: [
        f("h3", { children: t }),
        f("dl", { children: oo().filter((n) => n.group === t && n.keys).map((n) => T(Ic, { children: [
          f("dt", { children: n.label }),
          f("dd", { children: f("kbd", { children: n.keys }) })
        ] })) })
      ] }, t)),
      T("section", { children: [
        f("h3", { children: "Numbers" }),
        T("dl", { children: [
          f("dt", { children: "Level" }),
          f("dd", { children: "80 %, 450 lm, *0.8, +10, -1/2 stop, full, out" }),
          f("dt", { children: "Colour" }),
          f("dd", { children: "2700K" }),
          f("dt", { children: "Length" }),
          f("dd", { children: `2.4m, 75cm, 8'2", +=0.1` }),
          f("dt", { children: "Angle" }),
          f("dd", { children: "30°" })
        ] })
      ] })
    ] })
  ] }) });
}
var tn = ut(""), it = ut(0);
function Cc() {
  let e = tn.value.toLowerCase().split(/\s+/).filter(Boolean), t = (o) => e.every((a) => o.toLowerCase().includes(a)), n = oo().filter((o) => t(`${o.group} ${o.label}`)).map((o) => ({ label: o.label, note: o.keys ?? o.group, why: xc(o.id), run: () => Ll(o.id) }));
  for (let { name: o, camera: a } of At())
    t(`view ${o}`) && n.push({ label: `View: ${o}`, note: "view", why: null, run: () => fc(a, o) });
  if (e.length)
    for (let [o, a] of bc.all()) {
      if (n.length > 60) break;
      t(a.name) && n.push({ label: a.name, note: "lamp", why: null, run: () => vc("lamp", o) });
    }
  return n.slice(0, 60);
}
function $c() {
  let e = Cc(), t = Math.min(it.value, e.length - 1);
  ao(() => {
    tn.value = "", it.value = 0;
  }, []), ao(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (o) => {
    o && (st.value = null, o.why ? nn(o.why, "warn") : setTimeout(o.run, 0));
  };
  return T(ct, { title: "Command palette", children: [
    f(
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
        value: tn.value,
        onInput: (o) => {
          tn.value = o.currentTarget.value, it.value = 0;
        },
        onKeyDown: (o) => {
          let a = { ArrowDown: 1, ArrowUp: -1 }[o.key];
          a && (o.preventDefault(), it.value = (t + a + e.length) % Math.max(1, e.length)), o.key === "Enter" && (o.preventDefault(), n(e[t]));
        }
      }
    ),
    T("ul", { class: "commands", id: "commands", role: "listbox", "aria-label": "Commands", children: [
      e.map((o, a) => T(
        "li",
        {
          id: `command-${a}`,
          role: "option",
          "aria-selected": a === t,
          "aria-disabled": o.why !== null,
          title: o.why ?? void 0,
          onPointerMove: () => it.value = a,
          onClick: () => n(o),
          children: [
            f("span", { children: o.label }),
            f("kbd", { children: o.note })
          ]
        },
        o.label + a
      )),
      !e.length && f("li", { class: "quiet", role: "option", "aria-selected": "false", "aria-disabled": "true", children: "Nothing is called so." })
    ] })
  ] });
}
var Tl = ut([]);
gc("links", (e) => Tl.value = e.links);
function Lc({ text: e }) {
  let t = $l(e);
  if (!t) return null;
  let n = t.length + 8, o = t.map((a, l) => a.map((r, s) => r ? `M${s + 4} ${l + 4}h1v1h-1z` : "").join("")).join("");
  return T("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    f("rect", { width: n, height: n, fill: "#fff" }),
    f("path", { d: o, fill: "#000" })
  ] });
}
function Tc() {
  let e = ut(null), t = on(e).current;
  return ao(() => {
    en({ do: "links", what: "list" });
  }, []), T(ct, { title: "Share by link", children: [
    f("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    f("ul", { class: "links", children: Tl.value.map((n) => T("li", { children: [
      f("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      f("code", { children: n.address }),
      T("span", { class: "buttons", children: [
        f("button", { onClick: () => {
          dc(n.address);
        }, children: "Copy" }),
        f("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        f("button", { onClick: () => en({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && f(Lc, { text: n.address })
    ] }, n.id)) }),
    T("footer", { children: [
      f("button", { onClick: () => en({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      f("button", { onClick: () => en({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function Pc() {
  let e = on(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    mc({ do: "save", name: n }), st.value = null, nn(`Saving the version “${n}”.`);
  };
  return T(ct, { title: "Save a version", children: [
    f("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    T("label", { class: "line", children: [
      f("span", { children: "Name" }),
      f("span", { class: "field", children: f("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    f("footer", { children: f("button", { onClick: t, children: "Save" }) })
  ] });
}
var te = ut(null);
function Vc() {
  let e = yc.value?.head, t = on(null), n = (a) => t.current?.querySelector(`[name=${a}]`)?.value ?? "", o = () => {
    te.value = 0;
    let [a, l] = [Number(n("width")), Number(n("height"))];
    pc("picture", { format: n("format"), width: a, height: l, batches: Number(n("batches")) }, (r) => {
      r.why ? (te.value = null, nn(r.why, "warn")) : r.url ? (te.value = null, to(r.name, r.url), st.value = null) : te.value = r.progress ?? 0;
    }, (r) => {
      te.value = null, nn(r, "warn");
    });
  };
  return T(ct, { title: "Save the picture", children: [
    T("div", { ref: t, class: "form", children: [
      T("label", { class: "line", children: [
        f("span", { children: "Format" }),
        T("select", { name: "format", children: [
          f("option", { value: "png", children: "PNG, as it is shown" }),
          f("option", { value: "exr", children: "EXR, the light itself" })
        ] })
      ] }),
      T("label", { class: "line", children: [
        f("span", { children: "Width" }),
        f("input", { type: "number", name: "width", min: 16, max: 16384, value: Math.max(e?.width ?? 0, 640) })
      ] }),
      T("label", { class: "line", children: [
        f("span", { children: "Height" }),
        f("input", { type: "number", name: "height", min: 16, max: 16384, value: Math.max(e?.height ?? 0, 480) })
      ] }),
      T("label", { class: "line", children: [
        f("span", { children: "Batches" }),
        f("input", { type: "number", name: "batches", min: 1, max: 1e5, value: 64 })
      ] })
    ] }),
    te.value !== null && f("progress", { max: 1, value: te.value, "aria-label": "Rendering" }),
    T("footer", { children: [
      f("button", { onClick: () => Ll("command"), children: "Copy the command" }),
      f("button", { disabled: te.value !== null, onClick: o, children: te.value === null ? "Render and save" : te.value ? `${hc(te.value * 100)} %` : "Rendering…" })
    ] })
  ] });
}
function Ec() {
  switch (st.value) {
    case "help":
      return f(Sc, {});
    case "palette":
      return f($c, {});
    case "share":
      return f(Tc, {});
    case "save":
      return f(Pc, {});
    case "picture":
      return f(Vc, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import { act as Ac, colorText as Pl, cost as Rc, css as qc, LevelField as Fc, listed as Hc, pickRow as Nc, Power as Dc, select as Gc, three as Oc } from "./desk.js";
import { jsx as J, jsxs as lo } from "./desk.js";
function Wc() {
  return lo("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    J("span", {}),
    J("span", { children: "Name" }),
    J("span", { children: "Level" }),
    J("span", { children: "lm" }),
    J("span", { children: "White" })
  ] });
}
function Kc({ row: e, index: t, count: n }) {
  let o = Hc(e, t, n);
  if (!o) return null;
  let { lamp: a, entry: l } = o;
  return lo("div", { class: `sheet-row ${o.state}`, ...o.frame, children: [
    J(Dc, { of: o }),
    J("button", { class: "row-name", "aria-pressed": o.selected, title: a ? Rc(a) : void 0, onClick: (r) => Nc(r, e.kind, e.id), onDblClick: () => Ac("frame"), children: J("span", { children: l.name }) }),
    J(Fc, { of: o, label: "level" }),
    J("span", { class: "lumens", children: Oc(o.lumens) }),
    a ? lo("button", { class: "tint", "aria-label": `${l.name} colour: ${Pl(a)}`, onClick: () => Gc("lamp", e.id), children: [
      J("i", { class: "swatch", style: { background: qc(a.swatch) } }),
      Pl(a)
    ] }) : J("span", {})
  ] });
}

// src/later/strip.tsx
import {
  act as ro,
  command as Fl,
  digits as io,
  display as Bc,
  fade as an,
  Field as Hl,
  grids as Vl,
  Icon as Ke,
  looks as El,
  luxText as Il,
  maintained as We,
  maintenance as Uc,
  meters as Al,
  select as Rl,
  selection as ln,
  show as _c,
  signal as Xc,
  signed as Yc,
  storeLook as zc
} from "./desk.js";
import { Fragment as ep, jsx as x, jsxs as F } from "./desk.js";
var so = Xc("looks");
function jc() {
  return F("section", { class: "looks", "aria-label": "Looks", children: [
    F("header", { children: [
      x("h2", { children: "Looks" }),
      x("button", { class: "tab", onClick: () => so.value = "meters", children: "Meters" }),
      x("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: zc, children: x(Ke, { name: "plus" }) }),
      x("span", { class: "gap" }),
      F("label", { class: "tint", children: [
        "Fade",
        x(Hl, { label: "Cross-fade", quantity: "seconds", value: an.value, step: 0.5, set: (e) => an.value = Math.max(0, e(an.value)) })
      ] })
    ] }),
    F("ul", { children: [
      El.all().map(([e, t], n) => F("li", { class: "look", children: [
        F("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Fl({ do: "look", id: e, what: "recall", seconds: an.peek() }), children: [
          t.picture && x("img", { src: t.picture, alt: t.name, width: 96, height: 72 }),
          x("span", { "aria-hidden": t.picture ? "true" : void 0, children: t.name })
        ] }),
        x(Zc, { id: e, name: t.name })
      ] }, e)),
      !El.ids.value.length && x("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function Zc({ id: e, name: t }) {
  let n = `look-${e}`, o = (p) => {
    let i = p.getBoundingClientRect(), m = document.getElementById(n);
    m?.style.setProperty("left", `${Math.min(i.left, innerWidth - 296)}px`), m?.style.setProperty("bottom", `${innerHeight - i.top + 4}px`), m?.style.setProperty("top", "auto");
  }, a = Bc.value.false_color?.against === e, l = { popovertarget: n }, r = () => document.getElementById(n)?.hidePopover(), s = (p, i = {}) => {
    r(), Fl({ do: "look", id: e, what: p, ...i });
  };
  return F(ep, { children: [
    x("button", { class: "icon more", ...l, "aria-label": `More of ${t}`, onPointerDown: (p) => o(p.currentTarget), onFocus: (p) => o(p.currentTarget), children: x(Ke, { name: "more" }) }),
    F("div", { id: n, popover: "auto", class: "menu", children: [
      F("label", { class: "line", children: [
        x("span", { children: "Name" }),
        x("span", { class: "field", children: x("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (p) => s("rename", { name: p.currentTarget.value }) }) })
      ] }),
      x("button", { class: "item", onClick: () => s("update"), children: x("span", { children: "Update to what is set now" }) }),
      x("button", { class: "item", onClick: () => s("recall", { seconds: 0 }), children: x("span", { children: "Recall at once" }) }),
      x(
        "button",
        {
          class: "item",
          onClick: () => {
            r(), _c({ false_color: a ? null : ft(e) });
          },
          children: x("span", { children: a ? "End the difference" : "Difference to now" })
        }
      ),
      x("button", { class: "item", onClick: () => s("remove"), children: x("span", { children: "Remove" }) })
    ] })
  ] });
}
var ql = (e, t) => e == null ? "" : ` · Δ ${Yc(e * t)}`;
function Qc() {
  let e = Uc.value;
  return F("section", { class: "readings", "aria-label": "Meters and grids", children: [
    F("header", { children: [
      x("h2", { children: "Meters" }),
      x("button", { class: "tab", onClick: () => so.value = "looks", children: "Looks" }),
      x("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => ro("meter-tool"), children: x(Ke, { name: "meter" }) }),
      x("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => ro("grid"), children: x(Ke, { name: "grid" }) }),
      x("button", { onClick: () => ro("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      F("label", { class: "tint", title: "How high levels may be set, of each lamp's flux", children: [
        "up to",
        x(Hl, { label: "Highest level to reach targets", quantity: "level", value: Ie.value, step: 0.1, set: (t) => Ie.value = Math.min(10, Math.max(1, t(Ie.value))) })
      ] }),
      x("button", { onClick: xl, title: "Save all figures as CSV", children: "CSV" }),
      x("span", { class: "gap" }),
      x("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${io(e, 2)} maintained` })
    ] }),
    F("ul", { children: [
      Al.all().map(([t, n]) => {
        let o = n.lux;
        return x("li", { children: F("button", { class: "reading", "aria-pressed": ln.value?.kind === "meter" && ln.value.ids.includes(t), onClick: () => Rl("meter", t), children: [
          F("span", { class: "tint", children: [
            x(Ke, { name: "meter" }),
            n.name,
            " ",
            x(An, { of: Ft(n) })
          ] }),
          x("strong", { class: Rt(n) ? "unsettled" : "", children: o ? We(o[0]) : "…" }),
          F("small", { children: [
            o?.[1] != null ? `±${We(o[1], !1)}` : "measuring",
            " ",
            n.kind,
            ql(n.change, e),
            n.target ? ` · wants ${Il(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      Vl.all().map(([t, n]) => {
        let o = n.target;
        return x("li", { children: F("button", { class: "reading", "aria-pressed": ln.value?.kind === "grid" && ln.value.ids.includes(t), onClick: () => Rl("grid", t), children: [
          F("span", { class: "tint", children: [
            x(Ke, { name: "grid" }),
            n.name,
            " ",
            x(An, { of: Ht(n) })
          ] }),
          x("strong", { class: qt(n) ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${We(n.mean)}${n.error == null ? "" : ` ±${We(n.error, !1)}`}` }),
          F("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : io(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : We(n.min, !1),
            " to",
            " ",
            n.max == null ? "…" : We(n.max, !1),
            ql(n.change, e),
            o ? ` · wants ${Il(o.lux)}, U₀ ${io(o.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !Al.ids.value.length && !Vl.ids.value.length && x("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Jc() {
  return F("div", { class: "strip-parts", "data-tab": so.value, children: [
    x(jc, {}),
    x(Qc, {})
  ] });
}

// src/later/menus.tsx
import {
  camera as Gl,
  digits as Ol,
  display as tp,
  Field as sn,
  go as Wl,
  houseLights as uo,
  Item as Te,
  Range as np,
  show as co,
  theme as Nl,
  walking as op
} from "./desk.js";
import { Fragment as un, jsx as C, jsxs as ne } from "./desk.js";
var rn = Math.PI / 360;
function Dl(e) {
  let t = Gl.peek();
  t && Wl({ ...t, fov: Math.max(3, Math.min(140, e)) });
}
function ap() {
  let e = Gl.value, t = At();
  return ne(un, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((n) => C(Te, { id: n }, n)),
    C("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((n) => C(Te, { id: `preset-${n}` }, n)),
    C("hr", {}),
    t.length > 0 && C("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    t.map(({ name: n, camera: o }, a) => C("button", { class: "item", onClick: () => Wl(o, n), children: C("span", { children: n }) }, a)),
    t.length > 0 && C("hr", {}),
    e && !e.height && ne(un, { children: [
      ne("label", { class: "line", children: [
        C("span", { children: "Angle" }),
        C(sn, { label: "Vertical angle of view", quantity: "angle", value: e.fov, step: 1, set: (n) => Dl(n(e.fov)) })
      ] }),
      ne("label", { class: "line", children: [
        C("span", { children: "Focal length" }),
        C(sn, { label: "Focal length on 36 × 24 mm", quantity: "number", value: Math.round(120 / Math.tan(e.fov * rn)) / 10, text: `${Ol(12 / Math.tan(e.fov * rn), 1)} mm`, step: 1, set: (n) => Dl(Math.atan(12 / Math.max(2, n(12 / Math.tan(e.fov * rn)))) / rn) })
      ] }),
      C("hr", {})
    ] }),
    C(Te, { id: "walking", label: op.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    C(Te, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((n) => C(Te, { id: `hands-${n}` }, n))
  ] });
}
var lp = ["linear", "reinhard", "filmic"];
function rp() {
  let e = tp.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return ne(un, { children: [
    ne("fieldset", { children: [
      C("legend", { children: "Tone curve" }),
      C("div", { class: "segments", children: lp.map((n) => C("button", { "aria-pressed": e.tone === n, onClick: () => co({ tone: n }), children: n }, n)) })
    ] }),
    ne("fieldset", { children: [
      C("legend", { children: "White balance" }),
      ne("label", { class: "line", children: [
        C("span", { children: "White" }),
        C(sn, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => co({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      ne("label", { class: "line", children: [
        C("span", { children: "Tint" }),
        C(sn, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => co({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    C("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => C(Te, { id: n }, n))
  ] });
}
function ip() {
  return ne(un, { children: [
    ne("label", { class: "line", children: [
      C("span", { children: "House lights" }),
      C(np, { label: "House lights", value: uo.value, text: `${Ol(uo.value * 100)} %`, on: (e) => uo.value = Math.max(0.3, e) })
    ] }),
    C("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => C("button", { "aria-pressed": Nl.value === e, onClick: () => Nl.value = e, children: e }, e)) }),
    C("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => C(Te, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as cn, cut as sp, digits as Kl, edit as Bl, go as up, Icon as pt, Range as cp, setCut as pp, signal as mp, storeView as dp, viewName as hp, views as fp } from "./desk.js";
import { jsx as W, jsxs as po } from "./desk.js";
var pn = mp(null);
function gp() {
  let e = fp.all();
  return po("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    W("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => cn("home"), children: W(pt, { name: "home" }) }),
    W("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => cn("frame"), children: W(pt, { name: "frame" }) }),
    W("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => cn("back"), children: W(pt, { name: "back" }) }),
    W("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => cn("forth"), children: W(pt, { name: "forth" }) }),
    W("span", { class: "divide" }),
    e.map(([t, n], o) => pn.value === t ? W("span", { class: "field", children: W(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (a) => a?.focus(),
        onBlur: (a) => {
          let l = a.currentTarget.value.trim();
          pn.value = null, l && l !== n.name && Bl(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (a) => {
          a.stopPropagation(), a.key === "Escape" && (a.currentTarget.value = n.name ?? ""), (a.key === "Enter" || a.key === "Escape") && a.currentTarget.blur();
        }
      }
    ) }, t) : po(
      "button",
      {
        class: "saved-view",
        "aria-pressed": hp.value === n.name,
        title: `${n.name ?? "View"} (Alt+${o + 1}); double click or F2 renames, Delete removes`,
        onClick: () => up(n, n.name ?? "view"),
        onDblClick: () => pn.value = t,
        onKeyDown: (a) => {
          a.key === "F2" && (pn.value = t), a.key === "Delete" && (a.stopPropagation(), Bl(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          W("small", { children: o + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    W("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: dp, children: W(pt, { name: "plus" }) })
  ] });
}
function bp() {
  let e = sp.value;
  if (!e) return null;
  let t = e.height === null ? `${Kl(e.value, 2)} m` : `at ${Kl(e.height, 2)} m`;
  return po("label", { class: "cut", "data-scroll": !0, children: [
    W("span", { children: "Cut" }),
    W(
      cp,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => pp(n * e.most)
      }
    ),
    W("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as vp, useRef as yp } from "./desk.js";
import { jsx as Ul } from "./desk.js";
function kp() {
  let e = yp(null), t = (n) => {
    let o = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && o.setPointerCapture(n.pointerId);
    let a = n.type === "pointerup" || n.type === "pointercancel";
    if (!a && !o.hasPointerCapture(n.pointerId)) return;
    let l = o.getBoundingClientRect(), r = (i) => Math.max(-1, Math.min(1, i)), s = a ? 0 : r((n.clientX - l.left) / (l.width / 2) - 1), p = a ? 0 : r(1 - (n.clientY - l.top) / (l.height / 2));
    e.current?.style.setProperty("transform", `translate(${s * 28}px, ${-p * 28}px)`), vp(p, s);
  };
  return Ul("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: Ul("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as _l,
  closeWhat as Xl,
  digits as wp,
  hovered as Yl,
  Icon as xp,
  lamps as Mp,
  maintained as ge,
  nameOf as Sp,
  select as Cp,
  useEffect as $p,
  useRef as Lp,
  viewSize as Tp,
  what as Pp
} from "./desk.js";
import { jsx as B, jsxs as le } from "./desk.js";
var Pe = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], Vp = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function Ep() {
  let e = Pp.value, t = Lp(null);
  if ($p(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, o] = Tp.value, a = [...e.lamps].sort((c, g) => Pe(g) - Pe(c)), l = a.reduce((c, g) => c + Pe(g), 0) || 1, r = a.slice(0, 9), s = l - r.reduce((c, g) => c + Pe(g), 0), p = Math.max(8, Math.min(e.x + 12, n - 332)), i = Math.max(8, Math.min(e.y + 12, o - 150 - 35 * r.length)), m = e.lux ? `${ge(e.lux[0])} ±${ge(e.lux[1], !1)}` : "Measuring…";
  return le(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${p}px`, top: `${i}px` },
      onKeyDown: (c) => {
        c.key === "Escape" && (c.stopPropagation(), Xl(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        le("header", { children: [
          B("strong", { class: e.done ? "" : "unsettled", children: m }),
          B("span", { class: "quiet", children: "what lights this" }),
          B("button", { class: "icon", "aria-label": "Close", onClick: Xl, children: B(xp, { name: "close" }) })
        ] }),
        le("ol", { children: [
          r.map((c) => B(
            "li",
            {
              onPointerEnter: () => Yl.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => Yl.value = null,
              children: le("button", { class: "row", onClick: () => Cp("lamp", c.id), children: [
                B("span", { class: "name", children: Sp("lamp", c.id) }),
                le("span", { class: "figure", children: [
                  wp(100 * Pe(c) / l, Pe(c) / l < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                le("span", { class: "figure lux", children: [
                  ge(Pe(c)),
                  " ±",
                  ge(Vp(c), !1)
                ] }),
                le("span", { class: "shares", "aria-hidden": "true", children: [
                  B("i", { class: "direct", style: { width: `${100 * c.direct[0] / l}%` } }),
                  B("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / l}%` } }),
                  B("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / l}%` } })
                ] }),
                le("span", { class: "spoken", children: [
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
          a.length > r.length && le("li", { class: "quiet", children: [
            a.length - r.length === 1 ? "one more" : `${a.length - r.length} more together`,
            ": ",
            ge(s)
          ] }),
          !a.length && B("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        le("footer", { children: [
          B("span", { class: "key direct", children: "direct" }),
          B("span", { class: "key indirect", children: "indirect" }),
          B("span", { class: "key caustic", children: "caustic" }),
          B("span", { class: "gap" }),
          _l.value.some((c) => Mp.get(c)?.place?.direction) && B("button", { onClick: () => ze(_l.peek(), e.hit.point), children: "Aim here" }),
          B("button", { onClick: () => Ze(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Ts as Compare,
  bp as CutBar,
  pi as Gizmo,
  Wu as Inspector,
  Ju as Legend,
  ip as PageItems,
  rp as SeeingItems,
  Wc as SheetHead,
  Kc as SheetRow,
  Ec as Sheets,
  Jc as Strip,
  Pi as TypedHint,
  ap as ViewItems,
  gp as ViewStrip,
  kp as WalkPad,
  Ep as What
};
