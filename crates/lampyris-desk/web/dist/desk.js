// node_modules/preact/dist/preact.mjs
var E, Yr, Mo, Fe, xo, Tn, Qr, Cn, Jr, Co, So, cs, Gt = /* @__PURE__ */ Symbol.for("pv"), Pn = {}, $n = [], fs = /^m(i|n|o|s|text|space)$/, Eo = Array.isArray, To = $n.slice, et = Object.assign;
function Ze(e) {
  e && e.parentNode && e.remove();
}
function Zr(e, t, n) {
  var o, r, i, a = {}, s = arguments.length;
  for (i in t) i == "key" ? o = t[i] : i == "ref" && typeof e != "function" ? r = t[i] : a[i] = t[i];
  return s > 2 && (a.children = s > 3 ? To.call(arguments, 2) : n), Bt(e, a, o, r, null);
}
function Bt(e, t, n, o, r) {
  var i = { type: e, props: t, key: n, ref: o, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: Gt, __v: r || ++Yr, __i: -1, __u: 0 };
  return !r && E.vnode && E.vnode(i), i;
}
function X(e) {
  return e.children;
}
function gt(e, t) {
  this.props = e, this.context = t, this.__g = 0;
}
function Ne(e, t) {
  if (t == null) return e.__ && Ne(e.__, e.__i + 1);
  for (var n; t < e.__k.length; t++) if ((n = e.__k[t]) && n.__e) return n.__e;
  return typeof e.type != "function" || e.props.__P ? null : Ne(e);
}
function ps(e) {
  var t, n = e.__v, o = n.__e, r = [], i = [], a = e.__P;
  a && ((t = et({ constructor: Gt }, n)).__v = n.__v + 1, E.vnode && E.vnode(t), Po(a, t, n, e.__n, a.namespaceURI, 32 & n.__u ? [o] : null, r, o || Ne(n), 32 & n.__u, i), t.__v = n.__v, t.__.__k[t.__i] = t, ii(r, t, i), n.__ = n.__e = null, t.__e != o && ei(t));
}
function ei(e) {
  if ((e = e.__) && e.__c && !e.props.__P) return e.__e = null, e.__k.some(function(t) {
    return t && (e.__e = t.__e);
  }), ei(e);
}
function zr(e) {
  (8 & e.__g || (e.__g |= 8, Fe.push(e), Tn++)) && xo == E.debounceRendering || ((xo = E.debounceRendering) || queueMicrotask)(ti);
}
function ti() {
  try {
    for (var e, t = 1; Fe.length; ) Fe.length > t && Fe.sort(Qr), e = Fe.shift(), t = Fe.length, 8 & e.__g && ps(e);
  } finally {
    (Tn = Fe.length) && (xo || queueMicrotask)(ti);
  }
}
function ni(e, t, n, o, r, i, a, s, p, c, u) {
  var d, m, f, b, y, w, x = o.__k || $n, k = t.length;
  for (p = ds(n, t, x, p, k), d = 0; d < k; d++) (f = n.__k[d]) != null && (m = ~f.__i && x[f.__i] || Pn, f.__i = d, w = Po(e, f, m, r, i, a, s, p, c, u), b = f.__e, (m.ref != f.ref || 8 & m.__u) && (m.ref && $o(m.ref, null, f, m), f.ref && u.push(f.ref, f.__c || b, f)), y = y || b, 4 & f.__u ? (p = oi(f, p, e, !m.__v), m.__e && (m.__e = null)) : typeof f.type == "function" && w !== void 0 ? p = w : b && (p = b.nextSibling), f.__u &= -21);
  return n.__e = y, p;
}
function ds(e, t, n, o, r) {
  var i, a, s, p, c, u, d, m, f, b = n.length, y = b, w = 0, x = 0, k = e.__k = Array(r);
  for (i = 0; i < r; i++) (a = t[i]) != null && typeof a != "boolean" && typeof a != "function" ? (typeof a != "object" || a.constructor === String ? a = k[i] = Bt(null, a) : Eo(a) ? a = k[i] = Bt(X, { children: a }) : a.constructor === Gt && a.__b ? a = k[i] = Bt(a.type, a.props, a.key, a.ref, a.__v) : k[i] = a, p = i + w, a.__ = e, a.__b = e.__b + 1, s = null, ~(c = a.__i = ms(a, n, p, y)) && (y--, (s = n[c]) && (s.__u |= 2)), s && s.__v ? (a.__u |= 16, c == p - 1 ? w-- : c == p + 1 ? w++ : c != p && (c > p ? w-- : w++, x = 1)) : (~c || (r > b ? w-- : r < b && w++), typeof a.type != "function" && (a.__u |= 4))) : k[i] = null;
  if (x) {
    for (u = [], d = [], i = 0; i < r; i++) if ((a = k[i]) && 16 & a.__u) {
      for (w = 0, m = u.length; w < m; ) u[f = w + m >> 1] < a.__i ? w = f + 1 : m = f;
      u[w] = a.__i, d[i] = w + 1;
    }
    for (w = u.length; i--; ) d[i] && (d[i] == w ? w-- : k[i].__u |= 4);
  }
  if (y) for (i = 0; i < b; i++) !(s = n[i]) || 2 & s.__u || (s.__e == o && (o = Ne(s)), Lo(s, s));
  return o;
}
function oi(e, t, n, o) {
  var r, i, a, s;
  if (typeof e.type == "function") {
    if (e.props.__P) return t;
    if (r = e.__k) for (i = 0; i < r.length; i++) r[i] && (r[i].__ = e, t = oi(r[i], t, n, !1));
    return t;
  }
  for (t && !t.parentNode && (t = Ne(e)) && !t.parentNode && (t = null), a = e.__e, s = t; s && s.nodeType == 8; ) s = s.nextSibling;
  for (a != s && (!o && n.moveBefore && a.parentNode ? n.moveBefore(a, t) : n.insertBefore(a, t || null)), t = a; (t = t && t.nextSibling) && t.nodeType == 8 && !t.data.startsWith("$s"); ) ;
  return t;
}
function ms(e, t, n, o) {
  var r, i = e.key, a = e.type, s = t[n], p = s && !(2 & s.__u);
  if (s === null && i == null || p && i == s.key && a == s.type) return n;
  if (o > (p ? 1 : 0)) {
    for (r = n - 1; r >= 0; r--) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
    for (r = n + 1; r < t.length; r++) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
  }
  return -1;
}
function Xr(e, t, n) {
  n == null && (n = ""), t[0] == "-" ? e.setProperty(t, n) : e[t] = n;
}
function Mn(e, t, n, o, r) {
  var i, a;
  if (t == "style") if (typeof n == "string") e.style.cssText = n;
  else {
    if (typeof o == "string" && (e.style.cssText = o = ""), o) for (t in o) n && t in n || Xr(e.style, t);
    if (n) for (t in n) o && n[t] == o[t] || Xr(e.style, t, n[t]);
  }
  else if (t[0] == "o" && t[1] == "n") typeof n != "function" && (n = null), typeof o != "function" && (o = null), (e.__e || (e.__e = {}))[t] = n, n && o || (a = So[t] || (So[t] = hs(t)), (e.__a || (e.__a = {}))[t] = Co, i = t != (t = t.replace(Jr, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), n ? e.addEventListener(t, a, i) : e.removeEventListener(t, a, i));
  else {
    if (r == "http://www.w3.org/2000/svg") t = t.replace(/xlink(H|:h)/, "h").replace(/sName$/, "s");
    else if (t != "width" && t != "height" && t != "href" && t != "list" && t != "form" && t != "tabIndex" && t != "download" && t != "rowSpan" && t != "colSpan" && t != "role" && t != "popover" && t in e) try {
      return void (e[t] = n ?? "");
    } catch {
    }
    if (typeof n == "function") return;
    n == null || n === !1 && t[4] != "-" ? e.removeAttribute(t) : e.setAttribute(t, t == "popover" && n == 1 ? "" : n);
  }
}
function hs(e) {
  return function(t) {
    var n = this.__e;
    if (n) {
      if (n = n[e], t[Cn] == null) t[Cn] = Co++;
      else if (t[Cn] < this.__a[e]) return;
      return n(E.event ? E.event(t) : t);
    }
  };
}
function Po(e, t, n, o, r, i, a, s, p, c) {
  var u, d, m, f, b, y, w, x, k, _, C, Ce, Je, fe, ve, h, v, $, L = t.type;
  if (t.constructor !== Gt) return null;
  128 & n.__u && (p = 32 & n.__u, u = n.__c.__z) && (t.__u |= p, d = i = [], u.nodeType == 8 ? s = En(u, i) : i.push(u), s = i[0] || s), (u = E.__b) && u(t);
  e: if (typeof L == "function") {
    m = a.length;
    try {
      if (x = t.props, k = (u = L.prototype) && u.render, _ = (u = L.contextType) && o[u.__c], C = u ? _ ? _.props.value : u.__ : o, (f = n.__c) ? (t.__c = f, 2 & f.__g && (f.__g |= 1)) : (k ? t.__c = f = new L(x, C) : (t.__c = f = new gt(x, C), f.constructor = L, f.render = gs), _ && _.sub(f), f.state || (f.state = {}), f.__n = o, f.__g |= 8, f.__h = [], f.__k = []), k && (f.__s || (f.__s = f.state), L.getDerivedStateFromProps && (f.__s == f.state && (f.__s = et({}, f.__s)), et(f.__s, L.getDerivedStateFromProps(x, f.__s)))), b = f.props, y = f.state, f.__v = t, n.__c) {
        if (x !== b && k && !L.getDerivedStateFromProps && f.componentWillReceiveProps && f.componentWillReceiveProps(x, C), t.__v == n.__v && !(8 & f.__g) || !(4 & f.__g) && f.shouldComponentUpdate && f.shouldComponentUpdate(x, f.__s, C) === !1) {
          t.__v != n.__v && (f.props = x, f.state = f.__s, f.__g &= -9), t.__e = n.__e, t.__k = n.__k, t.__k.some(function(V) {
            V && (V.__ = t);
          }), $n.push.apply(f.__h, f.__k), f.__k = [], f.__h.length && a.push(f), s = Ne(n);
          break e;
        }
        f.componentWillUpdate && f.componentWillUpdate(x, f.__s, C), k && f.componentDidUpdate && f.__h.push(function() {
          f.componentDidUpdate(b, y, w);
        });
      } else k && !L.getDerivedStateFromProps && f.componentWillMount && f.componentWillMount(), k && f.componentDidMount && f.__h.push(f.componentDidMount);
      f.context = C, f.props = x, f.__P = e, f.__g &= -5, Ce = E.__r, Je = k ? 25 : 0;
      do
        f.__g &= -9, Ce && Ce(t), u = f.render(f.props, f.state = f.__s, f.context);
      while (8 & f.__g && ++Je < 25);
      k && ($n.push.apply(f.__h, f.__k), f.__k = []), f.state = f.__s, f.getChildContext && (o = et({}, o, f.getChildContext())), k && n.__c && f.getSnapshotBeforeUpdate && (w = f.getSnapshotBeforeUpdate(b, y)), fe = u && u.type === X && u.key == null ? u.props.children : u, x.__P && (u = s, r = (e = x.__P).namespaceURI, p = i = null, n.props && n.props.__P != e && (n.__k.some(function(V) {
        V && Lo(V, V);
      }), n.__k = null), s = n.__k ? Ne(n, 0) : null), s = ni(e, Eo(fe) ? fe : [fe], t, n, o, r, i, a, s, p, c), x.__P && (t.__e = null, s = u), t.__u &= -161, d && d.some(Ze), f.__h.length && a.push(f), 1 & f.__g && (f.__g &= -4);
    } catch (V) {
      if (a.length = m, t.__v = null, p || i) if (V && V.then) {
        if (t.__u |= 128 | p, i) {
          for (~(v = i.indexOf(s || void 0)) || (v = i.length); ($ = i[v - 1]) && $.nodeType == 8; ) v--;
          for (; v < i.length; v++) if ($ = i[v]) if (i[v] = null, ve) {
            if ($ == h) break;
          } else {
            if ($.nodeType != 8) break;
            $.data.startsWith("$s") && (h = En(ve = $));
          }
        }
        if (!ve) {
          for (; s && s.nodeType == 8 && s.nextSibling; ) s = s.nextSibling;
          ve = s;
        }
        (u = En(ve = t.__c.__z || (t.__c.__z = ve))) ? (t.__e = ve, s = u) : t.__e = s, s = s && s.nextSibling;
      } else i && i.some(Ze);
      else t.__e = n.__e;
      t.__k || (t.__k = n.__k || []), V && V.then || ri(t), E.__e(V, t, n);
    }
  } else s = t.__e = vs(n.__e, t, n, o, r, i, a, p, c, e);
  return (u = E.diffed) && u(t), s;
}
function En(e, t) {
  if (e && e.nodeType == 8 && e.data.startsWith("$s")) for (var n = 1; e = e.nextSibling; ) {
    if (e.nodeType == 8) {
      if (e.data.startsWith("$s")) n++;
      else if (e.data.startsWith("/$s") && !--n) return e;
    }
    t && t.push(e);
  }
}
function ri(e) {
  e && (e.__c && (e.__c.__g |= 4), e.__k && e.__k.some(ri));
}
function ii(e, t, n) {
  for (var o = 0; o < n.length; ) $o(n[o++], n[o++], n[o++]);
  E.__c && E.__c(t, e), e.some(function(r) {
    try {
      e = r.__h, r.__h = [], e.some(function(i) {
        i.call(r);
      });
    } catch (i) {
      E.__e(i, r.__v);
    }
  });
}
function vs(e, t, n, o, r, i, a, s, p, c) {
  var u, d, m, f, b, y, w, x, k = n.props || Pn, _ = t.props, C = t.type;
  if (C == "svg" ? r = "http://www.w3.org/2000/svg" : C == "math" ? r = "http://www.w3.org/1998/Math/MathML" : r || (r = "http://www.w3.org/1999/xhtml"), i) {
    for (u = 0; u < i.length; u++) if ((b = i[u]) && (C ? b.localName == C : b.nodeType == 3)) {
      e = b, i[u] = null;
      break;
    }
  }
  if (!e) {
    if (x = c.ownerDocument || document, !C) return x.createTextNode(_);
    e = x.createElementNS(r, C, _.is ? _ : c), s && (E.__m && E.__m(t, i), s = !1), i = null;
  }
  if (C) {
    if (c = C == "template" && e.content || e, i = C == "textarea" && _.defaultValue != null ? null : i && To.call(c.childNodes), !s && i) for (k = {}, u = 0; u < e.attributes.length; u++) k[(b = e.attributes[u]).name] = b.value;
    for (u in k) b = k[u], u == "dangerouslySetInnerHTML" ? m = b : u == "children" || u in _ || u == "value" && "defaultValue" in _ || u == "checked" && "defaultChecked" in _ || Mn(e, u, null, b, r);
    for (u in _) b = _[u], u == "children" ? f = b : u == "dangerouslySetInnerHTML" ? d = b : u == "value" ? y = b : u == "checked" ? w = b : s && typeof b != "function" || k[u] === b || Mn(e, u, b, k[u], r);
    d ? (s || m && (d.__html == m.__html || d.__html == e.innerHTML) || (e.innerHTML = d.__html), t.__k = []) : (m && (e.textContent = ""), (C == "foreignObject" || r == "http://www.w3.org/1998/Math/MathML" && fs.test(C)) && (r = "http://www.w3.org/1999/xhtml"), ni(c, Eo(f) ? f : [f], t, n, o, r, i, a, i ? i[0] : n.__k && Ne(n, 0), s, p), i && i.some(Ze)), s && C != "textarea" || (u = "value", C == "progress" && y == null ? e.removeAttribute(u) : y == null || y === e[u] && (C != "progress" || y) || Mn(e, u, y, k[u], r), u = "checked", w != null && w != e[u] && Mn(e, u, w, k[u], r));
  } else k === _ || s && e.data == _ || (e.data = _);
  return e;
}
function $o(e, t, n, o) {
  try {
    typeof e == "function" ? t ? t.__x = e(t) || 1 : o && (o = o.__c || o.__e) && (t = o.__x) && (o.__x = null, typeof t == "function" ? t() : e(null)) : e.current = t;
  } catch (r) {
    E.__e(r, n);
  }
}
function Lo(e, t, n) {
  var o, r, i, a;
  if (E.unmount && E.unmount(e), !(o = e.ref) || o.current && o.current != e.__e || $o(o, null, t, e), o = e.__c) {
    if (o.componentWillUnmount) try {
      o.componentWillUnmount();
    } catch (s) {
      E.__e(s, t);
    }
    o.__P = o.__n = null;
  }
  if (o = e.__k) for (a = 0; a < o.length; a++) o[a] && Lo(o[a], t, typeof e.type != "function" || n && !e.props.__P);
  !n && (o = e.__c) && (o = o.__z) && (r = En(o, i = [])) && (o == e.__e && i.some(Ze), Ze(r), Ze(o)), n || Ze(e.__e), e.__e = e.__c = e.__ = null;
}
function gs(e, t, n) {
  return this.constructor(e, n);
}
function ai(e, t) {
  var n, o, r, i;
  E.__ && E.__(e, t), t.nodeType == 9 && (t = t.documentElement), o = (n = e && 32 & e.__u) ? null : t.__k, t.__k = Bt(X, { children: [e] }), r = [], i = [], Po(t, t.__k, o || Pn, Pn, t.namespaceURI, o ? null : t.firstChild ? To.call(t.childNodes) : null, r, o ? o.__e : t.firstChild, n, i), ii(r, t.__k, i), t.__k.props.children = null;
}
E = { __e: function(e, t, n, o) {
  for (var r, i, a; t = t.__; ) if ((r = t.__c) && !(1 & r.__g)) {
    r.__g |= 4;
    try {
      if ((a = (i = r.constructor) && i.getDerivedStateFromError) && r.setState(i.getDerivedStateFromError(e)), r.componentDidCatch && (r.componentDidCatch(e, o || {}), a = 1), a && 8 & r.__g) return void (r.__g |= 2);
    } catch (s) {
      e = s;
    }
  }
  throw Tn = 0, e;
} }, Yr = 0, Mo = function(e) {
  return e != null && e.constructor === Gt;
}, gt.prototype.setState = function(e, t) {
  var n = this.__s;
  n && n != this.state || (n = this.__s = et({}, this.state)), typeof e == "function" && (e = e(et({}, n), this.props)), e && (et(n, e), this.__v && (t && this.__k.push(t), zr(this)));
}, gt.prototype.forceUpdate = function(e) {
  this.__v && (this.__g |= 4, e && this.__h.push(e), zr(this));
}, gt.prototype.render = X, Fe = [], Tn = 0, Qr = function(e, t) {
  return e.__v.__b - t.__v.__b;
}, Cn = /* @__PURE__ */ Symbol(), Jr = /(PointerCapture)$|Capture$/i, Co = 0, So = {}, cs = 0;

// node_modules/preact/hooks/dist/hooks.mjs
var Xt, ie, Vo, si, bs = Object.is, Io = 0, vi = [], Ao = [], j = E, li = j.__b, ui = j.__r, ci = j.diffed, fi = j.__c, pi = j.unmount, di = j.__;
function Ho(e, t) {
  j.__h && j.__h(ie, e, Io || t), Io = 0;
  var n = ie.__H || (ie.__H = { __: [], __h: [] });
  return e >= n.__.length && n.__.push({}), n.__[e];
}
function Ee(e, t) {
  var n = Ho(Xt++, 3);
  !j.__s && Ko(n.__H, t) && (n.__P = !0, n.__ = e, n.u = t, ie.__H.__h.push(n));
}
function ys(e, t) {
  var n = Ho(Xt++, 4);
  !j.__s && Ko(n.__H, t) && (n.__P = !1, n.__ = e, n.u = t, ie.__h.push(n));
}
function ne(e) {
  return Io = 5, Ln(function() {
    return { current: e };
  }, []);
}
function Ln(e, t) {
  var n = Ho(Xt++, 7);
  return Ko(n.__H, t) && (n.__ = e(), n.__H = t), n.__;
}
function _s() {
  var e;
  do {
    for (; e = Ao.shift(); ) try {
      zt(e);
    } catch (n) {
      j.__e(n, { __: (e = e.__P) && e.__v });
    }
    for (; e = vi.shift(); ) {
      var t = e.__H;
      if (e.__P && t) try {
        t.__h.some(zt), t.__h.some(Ro), t.__h = [];
      } catch (n) {
        t.__h = [], j.__e(n, e.__v);
      }
    }
  } while (Ao.length);
}
j.__b = function(e) {
  ie = null, li && li(e);
}, j.__ = function(e, t) {
  e && t.__k && t.__k.__m && (e.__m = t.__k.__m), di && di(e, t);
}, j.__r = function(e) {
  ui && ui(e), Xt = 0;
  var t = (ie = e.__c).__H;
  t && (Vo == ie ? ie.__h = [] : (t.__h.some(zt), t.__h.some(Ro), Xt = 0), t.__h = [], t.__.some(function(n) {
    n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
  })), Vo = ie;
}, j.diffed = function(e) {
  ci && ci(e);
  var t = e.__c;
  t && t.__H && (t.__H.__h.length && hi(vi.push(t)), t.__H.__.some(function(n) {
    n.u && (n.__H = n.u);
  })), Vo = ie = null;
}, j.__c = function(e, t) {
  t.some(function(n) {
    try {
      n.__h.some(zt), n.__h = n.__h.filter(function(o) {
        return !o.__ || Ro(o);
      });
    } catch (o) {
      n.__h = [function() {
        throw o;
      }];
    }
  }), fi && fi(e, t);
}, j.unmount = function(e) {
  pi && pi(e);
  var t, n, o = e.__c;
  o && o.__H && (o.__H.__.some(function(r) {
    try {
      if (r.__P && r.__c) {
        if (n === void 0) {
          for (n = e.__; n && (!n.__c || !n.__c.__P); ) n = n.__;
          n = n && n.__c;
        }
        r.__P = n, hi(Ao.push(r));
      } else zt(r);
    } catch (i) {
      t = i;
    }
  }), o.__H = void 0, t && j.__e(t, o.__v));
};
var mi = typeof requestAnimationFrame == "function";
function ws(e) {
  var t, n = function() {
    clearTimeout(o), mi && cancelAnimationFrame(t), setTimeout(e);
  }, o = setTimeout(n, 35);
  mi && (t = requestAnimationFrame(n));
}
function hi(e) {
  e != 1 && si == j.requestAnimationFrame || ((si = j.requestAnimationFrame) || ws)(_s);
}
function zt(e) {
  var t = ie, n = e.__c;
  typeof n == "function" && (e.__c = void 0, n()), ie = t;
}
function Ro(e) {
  var t = ie;
  e.__c = e.__(), ie = t;
}
function Ko(e, t) {
  return !e || e.length != t.length || t.some(function(n, o) {
    return !bs(n, e[o]);
  });
}

// node_modules/@preact/signals-core/dist/signals-core.module.js
var ks = /* @__PURE__ */ Symbol.for("preact-signals");
function Rn() {
  if (He > 1)
    He--;
  else {
    var e, t = !1;
    for ((function() {
      var r = In;
      for (In = void 0; r !== void 0; ) {
        var i = r.S;
        if (i.v === r.v) for (var a = i.t; a !== void 0; a = a.x) a.i === r.i && (a.i = i.i);
        r = r.o;
      }
    })(); Qt !== void 0; ) {
      var n = Qt;
      for (Qt = void 0, Vn++; n !== void 0; ) {
        var o = n.u;
        if (n.u = void 0, n.f &= -3, !(8 & n.f) && bi(n)) try {
          n.c();
        } catch (r) {
          t || (e = r, t = !0);
        }
        n = o;
      }
    }
    if (Vn = 0, He--, t) throw e;
  }
}
function Hn(e) {
  if (He > 0) return e();
  Oo = ++xs, He++;
  try {
    return e();
  } finally {
    Rn();
  }
}
var Yt, H = void 0;
function re(e) {
  var t = H, n = Yt;
  H = void 0, Yt = void 0;
  try {
    return e();
  } finally {
    H = t, Yt = n;
  }
}
var Qt = void 0, He = 0, Vn = 0, xs = 0, Oo = 0, In = void 0, An = 0;
function gi(e) {
  if (H !== void 0) {
    var t = e.n;
    if (t === void 0 || t.t !== H)
      return t = { i: 0, S: e, p: H.s, n: void 0, t: H, e: void 0, x: void 0, r: t }, H.s !== void 0 && (H.s.n = t), H.s = t, e.n = t, 32 & H.f && e.S(t), t;
    if (t.i === -1)
      return t.i = 0, t.n !== void 0 && (t.n.p = t.p, t.p !== void 0 && (t.p.n = t.n), t.p = H.s, t.n = void 0, H.s.n = t, H.s = t), t;
  }
}
function Y(e, t) {
  this.v = e, this.i = 0, this.n = void 0, this.t = void 0, this.l = 0, this.W = t?.watched, this.Z = t?.unwatched, this.name = t?.name;
}
Y.prototype.brand = ks;
Y.prototype.h = function() {
  return !0;
};
Y.prototype.S = function(e) {
  var t = this, n = this.t;
  n !== e && e.e === void 0 && (e.x = n, this.t = e, n !== void 0 ? n.e = e : re(function() {
    var o;
    (o = t.W) == null || o.call(t);
  }));
};
Y.prototype.U = function(e) {
  var t = this;
  if (this.t !== void 0) {
    var n = e.e, o = e.x;
    n !== void 0 && (n.x = o, e.e = void 0), o !== void 0 && (o.e = n, e.x = void 0), e === this.t && (this.t = o, o === void 0 && re(function() {
      var r;
      (r = t.Z) == null || r.call(t);
    }));
  }
};
Y.prototype.subscribe = function(e) {
  var t = this;
  return T(function() {
    var n = t.value;
    re(function() {
      return e(n);
    });
  }, { name: "sub" });
};
Y.prototype.valueOf = function() {
  return this.value;
};
Y.prototype.toString = function() {
  return this.value + "";
};
Y.prototype.toJSON = function() {
  return this.value;
};
Y.prototype.peek = function() {
  var e = this;
  return re(function() {
    return e.value;
  });
};
Object.defineProperty(Y.prototype, "value", { get: function() {
  var e = gi(this);
  return e !== void 0 && (e.i = this.i), this.v;
}, set: function(e) {
  if (e !== this.v) {
    if (Vn > 100) throw new Error("Cycle detected");
    (function(n) {
      He !== 0 && Vn === 0 && n.l !== Oo && (n.l = Oo, In = { S: n, v: n.v, i: n.i, o: In });
    })(this), this.v = e, this.i++, An++, He++;
    try {
      for (var t = this.t; t !== void 0; t = t.x) t.t.N();
    } finally {
      Rn();
    }
  }
} });
function g(e, t) {
  return new Y(e, t);
}
function bi(e) {
  for (var t = e.s; t !== void 0; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return !0;
  return !1;
}
function yi(e) {
  for (var t = e.s; t !== void 0; t = t.n) {
    var n = t.S.n;
    if (n !== void 0 && (t.r = n), t.S.n = t, t.i = -1, t.n === void 0) {
      e.s = t;
      break;
    }
  }
}
function _i(e) {
  for (var t = e.s, n = void 0; t !== void 0; ) {
    var o = t.p;
    t.i === -1 ? (t.S.U(t), o !== void 0 && (o.n = t.n), t.n !== void 0 && (t.n.p = o)) : n = t, t.S.n = t.r, t.r !== void 0 && (t.r = void 0), t = o;
  }
  e.s = n;
}
function tt(e, t) {
  Y.call(this, void 0, t), this.x = e, this.s = void 0, this.g = An - 1, this.f = 4;
}
tt.prototype = new Y();
tt.prototype.h = function() {
  if (this.f &= -3, 1 & this.f) return !1;
  if ((36 & this.f) == 32 || (this.f &= -5, this.g === An)) return !0;
  if (this.g = An, this.f |= 1, this.i > 0 && !bi(this))
    return this.f &= -2, !0;
  var e = H;
  try {
    yi(this), H = this;
    var t = this.x();
    (16 & this.f || this.v !== t || this.i === 0) && (this.v = t, this.f &= -17, this.i++);
  } catch (n) {
    this.v = n, this.f |= 16, this.i++;
  }
  return H = e, _i(this), this.f &= -2, !0;
};
tt.prototype.S = function(e) {
  if (this.t === void 0) {
    this.f |= 36;
    for (var t = this.s; t !== void 0; t = t.n) t.S.S(t);
  }
  Y.prototype.S.call(this, e);
};
tt.prototype.U = function(e) {
  if (this.t !== void 0 && (Y.prototype.U.call(this, e), this.t === void 0)) {
    this.f &= -33;
    for (var t = this.s; t !== void 0; t = t.n) t.S.U(t);
  }
};
tt.prototype.N = function() {
  if (!(2 & this.f)) {
    this.f |= 6;
    for (var e = this.t; e !== void 0; e = e.x) e.t.N();
  }
};
Object.defineProperty(tt.prototype, "value", { get: function() {
  if (1 & this.f) throw new Error("Cycle detected");
  var e = gi(this);
  if (this.h(), e !== void 0 && (e.i = this.i), 16 & this.f) throw this.v;
  return this.v;
} });
function N(e, t) {
  return new tt(e, t);
}
function wi(e) {
  var t = e.j;
  if (e.j = void 0, typeof t == "function") {
    He++;
    var n = H;
    H = void 0;
    try {
      t();
    } catch (o) {
      throw e.f &= -2, e.f |= 8, Do(e), o;
    } finally {
      H = n, Rn();
    }
  }
}
function Do(e) {
  for (var t = e.s; t !== void 0; t = t.n) t.S.U(t);
  e.x = void 0, e.s = void 0, wi(e);
}
function Ss(e) {
  if (H !== this) throw new Error("Out-of-order effect");
  _i(this), H = e, this.f &= -2;
  try {
    8 & this.f && Do(this);
  } finally {
    Rn();
  }
}
function bt(e, t) {
  this.x = e, this.j = void 0, this.s = void 0, this.u = void 0, this.f = 32, this.name = t?.name, Yt && Yt.push(this);
}
bt.prototype.c = function() {
  var e = this.S();
  try {
    if (8 & this.f || this.x === void 0) return;
    var t = this.x();
    typeof t == "function" && (this.j = t);
  } finally {
    e();
  }
};
bt.prototype.S = function() {
  if (1 & this.f) throw new Error("Cycle detected");
  this.f |= 1, this.f &= -9, wi(this), yi(this), He++;
  var e = H;
  return H = this, Ss.bind(this, e);
};
bt.prototype.N = function() {
  2 & this.f || (this.f |= 2, this.u = Qt, Qt = this);
};
bt.prototype.d = function() {
  this.f |= 8, 1 & this.f || Do(this);
};
bt.prototype.dispose = function() {
  this.d();
};
function T(e, t) {
  var n = new bt(e, t);
  try {
    n.c();
  } catch (r) {
    throw n.d(), r;
  }
  var o = n.d.bind(n);
  return o[Symbol.dispose] = o, o;
}

// node_modules/@preact/signals/dist/signals.module.js
var Fo, Zt, Kn, Ms = typeof window < "u" && !!window.__PREACT_SIGNALS_DEVTOOLS__, ki = [], xi = [];
T(function() {
  Fo = this.N;
})();
function yt(e, t) {
  E[e] = t.bind(null, E[e] || function() {
  });
}
function Jt(e) {
  if (Kn) {
    var t = Kn;
    Kn = void 0, t();
  }
  Kn = e && e.S();
}
function Si(e) {
  var t = this, n = e.data, o = nt(n);
  o.name = "ReactiveDom", o.value = n;
  var r = Ln(function() {
    for (var s = t, p = t.__v; p = p.__; ) if (p.__c) {
      p.__c.__$f |= 4;
      break;
    }
    var c = N(function() {
      var f = o.value.value;
      return f === 0 ? 0 : f === !0 ? "" : f || "";
    }), u = N(function() {
      return !Array.isArray(c.value) && !Mo(c.value);
    }), d = T(function() {
      if (this.N = Mi, u.value) {
        var f = c.value;
        s.__v && s.__v.__e && s.__v.__e.nodeType === 3 && (s.__v.__e.data = f);
      }
    }), m = t.__$u.d;
    return t.__$u.d = function() {
      d(), m.call(this);
    }, [u, c];
  }, []), i = r[0], a = r[1];
  return i.value ? a.peek() : a.value;
}
Si.displayName = "ReactiveTextNode";
Object.defineProperties(Y.prototype, { constructor: { configurable: !0, value: Zr(X, null).constructor }, type: { configurable: !0, value: Si }, props: { configurable: !0, get: function() {
  var e = this;
  return { data: { get value() {
    return e.value;
  } } };
} }, __b: { configurable: !0, value: 1 } });
yt("__b", function(e, t) {
  if (Jt(), Zt = void 0, typeof t.type == "string") {
    var n, o = t.props;
    for (var r in o) if (r !== "children") {
      var i = o[r];
      i instanceof Y && (n || (t.__np = n = {}), n[r] = i, o[r] = i.peek());
    }
  }
  e(t);
});
yt("__r", function(e, t) {
  if (e(t), t.type !== X) {
    Jt();
    var n, o = t.__c;
    o && (o.__$f &= -2, (n = o.__$u) === void 0 && (o.__$u = n = (function(r, i) {
      var a;
      return T(function() {
        a = this;
      }, { name: i }), a.c = r, a;
    })(/* @__PURE__ */ (function(r) {
      return function() {
        var i;
        Ms && ((i = this.y) == null || i.call(this)), r.__$f |= 1, r.setState({});
      };
    })(o), typeof t.type == "function" ? t.type.displayName || t.type.name : ""))), Zt = o, Jt(n);
  }
});
yt("__e", function(e, t, n, o) {
  Jt(), Zt = void 0, e(t, n, o);
});
yt("diffed", function(e, t) {
  Jt(), Zt = void 0;
  var n;
  if (typeof t.type == "string" && (n = t.__e)) {
    var o = t.__np, r = t.props, i = n.U;
    if (i) for (var a in i) {
      var s = i[a];
      s === void 0 || o && a in o || (s.d(), i[a] = void 0);
    }
    if (o) {
      i || (i = {}, n.U = i);
      for (var p in o) {
        var c = i[p], u = o[p];
        c === void 0 ? (c = Cs(n, p, u, r), i[p] = c) : c.o(u, r);
      }
    }
  }
  e(t);
});
function Cs(e, t, n, o) {
  var r = t in e && e.ownerSVGElement === void 0, i = g(n);
  return { o: function(a, s) {
    i.value = a, o = s;
  }, d: T(function() {
    this.N = Mi;
    var a = i.value.value;
    o[t] !== a && (o[t] = a, r ? e[t] = a : a != null && (a !== !1 || t[4] === "-") ? e.setAttribute(t, a) : e.removeAttribute(t));
  }) };
}
yt("unmount", function(e, t) {
  if (typeof t.type == "string") {
    var n = t.__e;
    if (n) {
      var o = n.U;
      if (o) {
        n.U = void 0;
        for (var r in o) {
          var i = o[r];
          i && i.d();
        }
      }
    }
    var a = t.__np;
    if (a) {
      var s = t.props;
      for (var p in a) s[p] = a[p];
    }
    t.__np = void 0;
  } else {
    var c = t.__c;
    if (c) {
      c.__$f |= 8;
      var u = c.__$u;
      u && (c.__$u = void 0, u.d());
    }
  }
  e(t);
});
yt("__h", function(e, t, n, o) {
  o < 3 && (t.__$f |= 2), e(t, n, o);
});
gt.prototype.shouldComponentUpdate = function(e, t) {
  if (this.__R) return !0;
  var n = this.__$u, o = n && n.s !== void 0;
  for (var r in t) return !0;
  if (this.__f || typeof this.u == "boolean" && this.u === !0) {
    var i = 2 & this.__$f;
    if (!(o || i || 4 & this.__$f) || 1 & this.__$f) return !0;
  } else if (!(o || 4 & this.__$f) || 3 & this.__$f) return !0;
  for (var a in e) if (a !== "__source" && e[a] !== this.props[a]) return !0;
  for (var s in this.props) if (!(s in e)) return !0;
  return !1;
};
function nt(e, t) {
  return Ln(function() {
    return g(e, t);
  }, []);
}
var Es = typeof requestAnimationFrame > "u" ? setTimeout : function(e) {
  var t = function() {
    clearTimeout(n), cancelAnimationFrame(o), e();
  }, n = setTimeout(t, 35), o = requestAnimationFrame(t);
}, Ts = function(e) {
  queueMicrotask(function() {
    queueMicrotask(e);
  });
};
function Ps() {
  Hn(function() {
    for (var e; e = ki.shift(); ) Fo.call(e);
  });
}
function $s() {
  ki.push(this) === 1 && (E.requestAnimationFrame || Es)(Ps);
}
function Ls() {
  Hn(function() {
    for (var e; e = xi.shift(); ) Fo.call(e);
  });
}
function Mi() {
  xi.push(this) === 1 && (E.requestAnimationFrame || Ts)(Ls);
}
function Ci(e, t) {
  var n = ne(e);
  n.current = e;
  var o = Zt;
  Ee(function() {
    return T(function() {
      if (this.N = $s, !(o && 8 & o.__$f)) return n.current();
    }, t);
  }, []);
}

// src/vec.ts
var I = (e, t) => [e[0] + t[0], e[1] + t[1], e[2] + t[2]], O = (e, t) => [e[0] - t[0], e[1] - t[1], e[2] - t[2]], S = (e, t) => [e[0] * t, e[1] * t, e[2] * t], q = (e, t) => e[0] * t[0] + e[1] * t[1] + e[2] * t[2], ge = (e, t) => [
  e[1] * t[2] - e[2] * t[1],
  e[2] * t[0] - e[0] * t[2],
  e[0] * t[1] - e[1] * t[0]
], be = (e) => Math.hypot(e[0], e[1], e[2]), Ke = (e, t) => be(O(e, t)), Vs = (e, t, n) => I(S(e, 1 - n), S(t, n));
function Z(e, t = [0, 0, 1]) {
  let n = be(e);
  return n > 1e-12 ? S(e, 1 / n) : t;
}
function ot(e) {
  let t = Math.abs(e[0]) < 0.7 * be(e) ? [1, 0, 0] : [0, 1, 0];
  return Z(ge(t, e));
}
function en(e, t, n) {
  let o = Math.cos(n), r = Math.sin(n);
  return I(I(S(e, o), S(ge(t, e), r)), S(t, q(t, e) * (1 - o)));
}
function _t([e, t]) {
  return Array.from({ length: 8 }, (n, o) => [
    o & 1 ? t[0] : e[0],
    o & 2 ? t[1] : e[1],
    o & 4 ? t[2] : e[2]
  ]);
}
var qe = ([e, t]) => Vs(e, t, 0.5);

// src/camera.ts
var No = Math.PI / 180, On = 89 * No;
function wt(e, t, n) {
  let o = Z(O(e.target, e.eye), [0, 0, -1]), r = Z(ge(o, e.up), ot(o)), i = ge(r, o), a = e.height != null && e.height > 0, s = a ? e.height / n : 2 * Math.tan(e.fov * No * 0.5) / n;
  return { eye: e.eye, forward: o, side: r, up: i, width: t, height: n, pixel: s, parallel: a };
}
function tn(e, t) {
  let n = O(t, e.eye), o = q(n, e.forward), r = e.parallel ? e.pixel : e.pixel * o;
  return [e.width / 2 + q(n, e.side) / r, e.height / 2 - q(n, e.up) / r, o];
}
function Is(e, t, n) {
  let o = (t - e.width / 2) * e.pixel, r = (e.height / 2 - n) * e.pixel, i = I(S(e.side, o), S(e.up, r));
  return e.parallel ? { origin: I(e.eye, i), direction: e.forward } : { origin: e.eye, direction: Z(I(e.forward, i)) };
}
function Ei(e, t, n, o) {
  let r = O(e.target, e.eye), i = Math.max(be(r), 1e-3), a = Math.asin(Math.max(-1, Math.min(1, q(Z(r), t)))), s = O(r, S(t, q(r, t))), p = Z(be(s) > 1e-6 * i ? s : O(e.up, S(t, q(e.up, t))), ot(t)), c = Math.max(-On, Math.min(On, a + o)), u = en(p, t, n), d = I(S(u, Math.cos(c)), S(t, Math.sin(c)));
  return { ...e, up: t, target: I(e.eye, S(d, i)) };
}
function Ti(e, t, n, o, r) {
  let i = O(e.target, e.eye), a = O(i, S(t, q(i, t))), s = Z(be(a) > 1e-6 ? a : e.up, ot(t)), p = Z(ge(s, t)), c = I(I(S(s, n), S(p, o)), S(t, r));
  return je(e, c);
}
function Pi(e, t, n, o, r) {
  let i = Z(O(e.target, e.eye)), a = Z(ge(i, e.up), ot(i));
  return je(e, I(I(S(i, n), S(a, o)), S(t, r)));
}
function je(e, t) {
  return { ...e, eye: I(e.eye, t), target: I(e.target, t) };
}
function $i(e, t, n, o, r) {
  let i = Z(O(e.target, e.eye)), a = Math.asin(Math.max(-1, Math.min(1, q(i, t)))), s = Math.max(-On, Math.min(On, a + r)), p = Z(ge(i, t), Z(ge(i, e.up), ot(i))), c = (u) => en(en(u, p, s - a), t, o);
  return {
    ...e,
    up: t,
    eye: I(n, c(O(e.eye, n))),
    target: I(n, c(O(e.target, n)))
  };
}
function Li(e, t, n, o, r) {
  let i = t.parallel ? t.pixel : t.pixel * r;
  return je(e, I(S(t.side, -n * i), S(t.up, o * i)));
}
function Dn(e, t, n, o, r) {
  let i = O(t, e.eye), a = be(i);
  if (a < 1e-9) return e;
  let s = a * (1 - n);
  return r ? s = Math.sign(s) * Math.max(Math.abs(s), 0.5 * Math.abs(1 - n)) : s > 0 && (s = Math.max(0, Math.min(s, a - o))), je(e, S(i, s / a));
}
function Fn(e, t, n, o, r) {
  let i = Math.max(0.05, Math.min(1e5, (e.height ?? 1) * r)), a = (1 - i / (e.height ?? 1)) * t.pixel, s = I(
    S(t.side, (n - t.width / 2) * a),
    S(t.up, (t.height / 2 - o) * a)
  );
  return { ...je(e, s), height: i };
}
function Vi(e, t, n = 0.4) {
  let o = qe(t), r = Math.max(Ke(t[0], t[1]) / 2, 0.5), i = Z(O(e.eye, e.target));
  if (e.height) {
    let s = q(O(e.eye, o), i);
    return { ...e, eye: I(o, S(i, s)), target: o, height: r * 3 };
  }
  let a = Math.max(1.5 * r / Math.tan(e.fov * No * 0.5), n + r);
  return { ...e, eye: I(o, S(i, a)), target: o };
}
var As = ["plan", "ceiling", "north", "east", "south", "west"];
function Ii(e) {
  let t = Math.abs(e[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], n = Z(ge(e, t));
  return { right: Z(ge(n, e)), ahead: n };
}
function Ai(e, t, n, o) {
  let { right: r, ahead: i } = Ii(n), a = qe(t), s = (b) => Math.abs(q(O(t[1], t[0]), b)), c = {
    plan: { forward: S(n, -1), up: i, side: r, cut: 0.15 },
    ceiling: { forward: n, up: S(i, -1), side: r, cut: 0.35 },
    north: { forward: i, up: n, side: r, cut: 0.25 },
    south: { forward: S(i, -1), up: n, side: r, cut: 0.25 },
    east: { forward: r, up: n, side: i, cut: 0.25 },
    west: { forward: S(r, -1), up: n, side: i, cut: 0.25 }
  }[e], u = s(c.forward), d = 1, m = O(a, S(c.forward, u / 2 + d)), f = 1.08 * Math.max(s(c.up), s(c.side) / o, 0.1);
  return { eye: m, target: a, up: c.up, fov: 50, height: f, near: d + u * c.cut };
}
function nn(e, t) {
  let n = (r, i) => Ke(r, i) < 1e-4, o = (r, i) => Math.abs((r ?? -1) - (i ?? -1)) < 1e-4;
  return n(e.eye, t.eye) && n(e.target, t.target) && n(e.up, t.up) && o(e.fov, t.fov) && o(e.height, t.height) && o(e.near, t.near);
}

// src/counters.ts
var ae = {
  frame: 0,
  seqApplied: 0,
  frames: [],
  sent: [],
  entered: 0,
  firstDrawn: 0
}, Ri = 0;
for (let e of ["input", "pointermove", "pointerdown", "keydown", "wheel"])
  addEventListener(e, (t) => Ri = t.timeStamp, { capture: !0, passive: !0 });
function Hi(e, t) {
  ae.sent.push({ seq: e, what: t, at: performance.now(), input: Ri }), ae.sent.length > 1024 && ae.sent.shift();
}
function Ki(e) {
  ae.frame = e.frame, ae.seqApplied = e.seq, ae.firstDrawn ||= e.drawn, ae.frames.push(e), ae.frames.length > 1024 && ae.frames.shift(), requestAnimationFrame(() => {
    let t = new MessageChannel();
    t.port1.onmessage = () => {
      e.painted = performance.now(), t.port1.close();
    }, t.port2.postMessage(0);
  });
}
window.__desk = ae;

// src/store.ts
var Nn = /* @__PURE__ */ new Set(), kt = (e) => typeof e == "object" && e !== null && !Array.isArray(e);
function an(e, t) {
  if (!kt(e) || !kt(t)) return t;
  let n = { ...e };
  for (let [o, r] of Object.entries(t)) n[o] = an(n[o], r);
  return n;
}
var on = class {
  constructor(t) {
    this.server = t;
    this.shown = g(t);
  }
  server;
  shown;
  own = /* @__PURE__ */ new Map();
  /** The server's word. */
  receive(t) {
    this.server = t, this.show();
  }
  /** The page's word, until a patch of `seq`; infinite while it is held. */
  keep(t, n) {
    for (let [o, r] of Object.entries(t)) {
      let i = this.shown.peek()[o];
      this.own.set(o, { value: an(i, r), seq: n });
    }
    Nn.add(this), this.show();
  }
  /** The hand has let go: these fields wait for a patch of `seq` from now on. */
  settle(t, n) {
    for (let o of Object.keys(t)) {
      let r = this.own.get(o);
      r && (r.seq = n);
    }
  }
  /** Forgets what the server has followed. */
  release(t) {
    let n = !1;
    for (let [o, r] of this.own)
      r.seq <= t && (n = this.own.delete(o) || n);
    this.own.size === 0 && Nn.delete(this), n && this.show();
  }
  show() {
    if (this.own.size === 0) {
      this.shown.value = this.server;
      return;
    }
    let t = {};
    for (let [n, o] of this.own) t[n] = o.value;
    this.shown.value = { ...this.server, ...t };
  }
};
function Oi(e) {
  let { name: t, group: n, lamps: o } = e;
  return `${t} ${n} ${o}`;
}
var Te = class {
  /** Numbers of the entries there are, ascending; changes only when one comes or goes. */
  ids = g([]);
  /** Grows when an entry is called otherwise or belongs elsewhere: what lists are made of. */
  order = g(0);
  entries = /* @__PURE__ */ new Map();
  get(t) {
    if (t == null) return;
    let n = this.entries.get(t);
    if (n) return n.shown.value;
    this.ids.value;
  }
  has(t) {
    return this.ids.value, this.entries.has(t);
  }
  entry(t) {
    return this.entries.get(t);
  }
  /** All entries as they are; whoever asks inside of an effect hears only of what changes lists. */
  listed() {
    return this.order.value, this.ids.value.map((t) => [t, this.entries.get(t).shown.peek()]);
  }
  /** All entries; whoever asks inside of an effect hears of each change. */
  all() {
    return this.ids.value.map((t) => [t, this.entries.get(t).shown.value]);
  }
  whole(t) {
    let n = /* @__PURE__ */ new Map();
    for (let [o, r] of Object.entries(t ?? {})) n.set(Number(o), new on(r));
    this.entries = n, this.number();
  }
  patch(t) {
    let n = !1;
    for (let [o, r] of Object.entries(t)) {
      let i = Number(o), a = this.entries.get(i);
      r === null ? n = this.entries.delete(i) || n : a ? (Oi(a.shown.peek()) !== Oi(r) && this.order.value++, a.receive(r)) : (this.entries.set(i, new on(r)), n = !0);
    }
    n && this.number();
  }
  number() {
    this.ids.value = [...this.entries.keys()].sort((t, n) => t - n);
  }
}, M = new Te(), D = new Te(), ye = new Te(), xt = new Te(), St = new Te(), Mt = new Te(), Ct = new Te(), qn = new Te(), rn = {
  lamps: M,
  groups: D,
  things: ye,
  materials: xt,
  views: St,
  looks: Mt,
  meters: Ct,
  grids: qn
}, ee = g(null), sn = g([]), xe = g([]), rt = g({ undo: null, redo: null, steps: 0 }), it = g({ state: "clean", file: "" }), F = g({ you: !0, name: null }), Pe = g(null), jn = new on({
  ev: null,
  metered: !1,
  tone: "filmic",
  white: null,
  false_color: null
}), at = jn.shown, qo = {
  scene: ee,
  layers: sn,
  solo: xe,
  history: rt,
  saved: it,
  editor: F,
  status: Pe
};
function Di(e) {
  Nn.clear();
  for (let [t, n] of Object.entries(rn)) n.whole(e[t]);
  for (let [t, n] of Object.entries(qo)) t in e && (n.value = e[t]);
  kt(e.display) && jn.receive(e.display);
}
function Fi(e, t) {
  for (let [n, o] of Object.entries(e))
    n in rn ? rn[n].patch(o) : n === "display" ? jn.receive(o) : n in qo && (qo[n].value = o);
  Et(t);
}
function Et(e) {
  for (let t of [...Nn]) t.release(e);
}
function Ni(e, t) {
  for (let [n, o] of Object.entries(e))
    if (n in rn && kt(o))
      for (let [r, i] of Object.entries(o)) {
        let a = rn[n].entry(Number(r));
        a && kt(i) && t(a, i);
      }
    else n === "display" && kt(o) && t(jn, o);
}
var jo = (e, t) => Ni(e, (n, o) => n.keep(o, t)), Un = (e, t) => Ni(e, (n, o) => n.settle(o, t));
function st(e) {
  let t = D.get(e.group);
  return e.on && !e.parked && (t?.on ?? !0) ? e.level * (t?.level ?? 1) : 0;
}
function Uo(e) {
  return e.reduce((t, n) => {
    let o = M.get(n);
    return t + (o ? o.flux * st(o) : 0);
  }, 0);
}
var qi = N(() => {
  let e = M.all();
  return e.length > 0 && e.every(([, t]) => st(t) === 0);
});
function Rs(e, t) {
  let n = t.trim().toLowerCase();
  return e.all().filter(([, o]) => !n || o.name.toLowerCase().includes(n));
}

// src/wire.ts
var U = g("entering"), cn = g(0), pe = g("edit"), Wn = g(null), Oe = g(0), ji = () => null, Ui = (e) => {
  ji = e;
}, Bn = /* @__PURE__ */ new Map(), Ue = null, ln = 0, Wo = null, un = 0, Tt = "", Gn = !1;
function Se(e, t) {
  let n = Bn.get(e) ?? /* @__PURE__ */ new Set();
  return Bn.set(e, n.add(t)), () => n.delete(t);
}
function K(e) {
  return !Ue || Ue.readyState !== WebSocket.OPEN || U.peek() !== "open" ? 0 : (ln += 1, Ue.send(JSON.stringify({ ...e, seq: ln })), e.do !== "ack" && Hi(ln, e.do), ln);
}
var Hs = 0, lt = /* @__PURE__ */ new Map();
function Me(e, t, n, o = () => {
}) {
  let r = ++Hs, i = Se("answer", (s) => {
    s.id === r && (s.done !== !1 && i(), n(s));
  }), a = K({ do: "ask", id: r, what: e, ...t });
  if (!a)
    return i(), o("There is no connection to the program."), i;
  lt.set(a, (s) => {
    i(), o(s);
  });
  for (let s of lt.keys()) {
    if (s > a - 300) break;
    lt.delete(s);
  }
  return i;
}
function Ks(e) {
  switch (e.is) {
    case "hello":
      if (un = 0, Wo !== null && e.build !== Wo) {
        U.value = "renewed", Ue?.close();
        return;
      }
      Wo = e.build, pe.value = e.role === "watch" ? "watch" : "edit", Wn.value = e.you === void 0 ? null : String(e.you), Oe.value = 0, lt.clear(), U.value = "open";
      break;
    case "state":
      Di(e.state ?? e);
      break;
    case "patch":
      (e.by == null || String(e.by) === Wn.value) && Bo(e.seq), Fi(e.patch ?? {}, Oe.value);
      break;
    case "status":
      Pe.value = e;
      break;
    case "refused":
      if (Bo(e.seq), Et(Oe.value), lt.has(e.seq)) {
        lt.get(e.seq)?.(e.why ?? ""), lt.delete(e.seq);
        return;
      }
      break;
    case "event":
      e.what === "bye" && (Gn = !0);
      break;
  }
  for (let t of [...Bn.get(e.is) ?? []]) t(e);
}
function Bo(e) {
  typeof e == "number" && e > Oe.value && (Oe.value = e);
}
async function Wi() {
  if (!Tt) return "in";
  try {
    return (await fetch("/enter", {
      method: "POST",
      headers: { "content-type": "application/json" },
      body: JSON.stringify({ key: Tt })
    })).ok ? "in" : "denied";
  } catch {
    return "away";
  }
}
function Bi() {
  let e = location.protocol === "https:" ? "wss" : "ws", t = new WebSocket(`${e}://${location.host}/wire`);
  t.binaryType = "arraybuffer";
  let n = !1;
  Ue = t, Bn.get("line")?.forEach((o) => o({ is: "line" })), t.onmessage = (o) => {
    if (t !== Ue) return;
    if (typeof o.data != "string") {
      let i = ji(o.data);
      i && F.value.you && Bo(i.seq);
      return;
    }
    let r = JSON.parse(o.data);
    r.is === "hello" && (n = !0, ln = 0), Ks(r);
  }, t.onclose = () => {
    t === Ue && (Ue = null, U.value !== "renewed" && Os(n));
  };
}
async function Os(e) {
  if (Et(1 / 0), !e && await Ds()) {
    let o = await Wi();
    if (o === "denied" || o === "in" && un > 4 && !Tt) {
      U.value = "denied";
      return;
    }
  }
  un += 1;
  let t = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
  un > 3 && t && (Gn = !0), U.value = Gn ? "ended" : "lost";
  let n = Math.min(5, un);
  for (let o = n; o > 0; o--)
    cn.value = o, await new Promise((r) => setTimeout(r, 1e3));
  cn.value = 0, Bi();
}
async function Ds() {
  try {
    return await fetch("/", { cache: "no-store" }), !0;
  } catch {
    return !1;
  }
}
async function Gi() {
  let e = location.hash.slice(1);
  if (e ? (Tt = e, sessionStorage.setItem("lampyris-key", Tt), window.history.replaceState(null, "", location.pathname + location.search)) : Tt = sessionStorage.getItem("lampyris-key") ?? "", ae.entered = performance.now(), e && await Wi() === "denied") {
    U.value = "denied";
    return;
  }
  Bi();
}
Se("hello", () => Gn = !1);

// src/frames.ts
var W = g(null), $t = g(0), zi = ["moving", "settled", "final"], Xi = 32, Pt = /* @__PURE__ */ new Map(), $e = null, Go = null, zo = !1, ut = null;
function Fs(e) {
  if (e.byteLength < Xi) return null;
  let t = new DataView(e);
  return { head: {
    frame: t.getUint32(0, !0),
    seq: t.getUint32(4, !0),
    camera: t.getUint32(8, !0),
    width: t.getUint16(12, !0),
    height: t.getUint16(14, !0),
    kind: zi[Math.min(t.getUint8(16), 2)],
    falseColor: (t.getUint8(18) & 1) === 1,
    batches: t.getUint32(20, !0),
    error: t.getFloat32(24, !0),
    light: t.getUint16(28, !0) / 10,
    encode: t.getUint16(30, !0) / 10
  }, mime: t.getUint8(17) === 1 ? "image/png" : "image/jpeg" };
}
function Ns(e) {
  let t = Fs(e);
  return t ? (ut && K({ do: "ack", frame: ut.head.frame }), ut = { ...t, bytes: e, received: performance.now() }, zo || qs(), t.head) : null;
}
async function qs() {
  for (zo = !0; ut; ) {
    let { head: e, mime: t, bytes: n, received: o } = ut;
    ut = null;
    try {
      let r = await createImageBitmap(new Blob([new Uint8Array(n, Xi)], { type: t }));
      js(e, r, n.byteLength, o);
    } catch {
    }
    K({ do: "ack", frame: e.frame });
  }
  zo = !1;
}
function js(e, t, n, o) {
  let r = performance.now();
  $e && Go && (($e.width !== t.width || $e.height !== t.height) && ($e.width = t.width, $e.height = t.height), Go.drawImage(t, 0, 0)), t.close();
  let i = Pt.get(e.camera) ?? W.peek()?.camera;
  i && (W.value = { head: e, camera: i }), Us(), Ki({
    frame: e.frame,
    seq: e.seq,
    kind: zi.indexOf(e.kind),
    width: e.width,
    height: e.height,
    bytes: n,
    batches: e.batches,
    received: o,
    decoded: r,
    drawn: performance.now(),
    painted: 0,
    light: e.light,
    encode: e.encode
  });
}
var zn = [];
function Us() {
  let e = performance.now();
  zn = zn.filter((t) => e - t < 1e3), zn.push(e), $t.value = zn.length;
}
function Xo(e) {
  $e = e, Go = e?.getContext("2d", { alpha: !1 }) ?? null;
}
function Yi() {
  if (!$e || !W.peek()) return null;
  let e = document.createElement("canvas");
  return e.width = $e.width, e.height = $e.height, e.getContext("2d", { alpha: !1 })?.drawImage($e, 0, 0), e;
}
Ui(Ns);
Se("camera", (e) => {
  Pt.set(e.number, e);
  for (let t of Pt.keys()) {
    if (Pt.size <= 64) break;
    Pt.delete(t);
  }
});
Se("line", () => {
  Pt.clear(), ut = null;
});

// src/prefs.ts
var Qi = "lampyris-";
function se(e, t) {
  let n = t;
  try {
    let r = localStorage.getItem(Qi + e);
    r !== null && (n = JSON.parse(r));
  } catch {
  }
  let o = g(n);
  return T(() => {
    let r = JSON.stringify(o.value);
    try {
      localStorage.setItem(Qi + e, r);
    } catch {
    }
  }), o;
}
var Yo = se("theme", "dark"), Qo = se("house-lights", 1), Xn = se("hands", "default"), Jo = se("walking", "walk"), Zo = se("panels", !0), Lt = se("listing", "faders"), Yn = se("travel", "square"), Vt = se("candles", "lx"), er = se("single-keys", !0), tr = se("lamp-marks", !0), Ws = se("maintenance", 1), Bs = se("work-plane", 0.75), We = se("fine", !1), nr = se("fade", 1), Gs = typeof matchMedia == "function" && matchMedia("(pointer: coarse)").matches, _e = se("look-only", Gs);

// src/say.ts
var ct = g([]), zs = 0;
function le(e, t = "plain") {
  if (ct.peek().find((r) => r.text === e)) return;
  let o = ++zs;
  ct.value = [...ct.peek().slice(-2), { id: o, text: e, tone: t }], setTimeout(() => or(o), t === "warn" ? 8e3 : 4e3);
}
function or(e) {
  ct.value = ct.peek().filter((t) => t.id !== e);
}

// src/gesture.ts
var It = 0, ea = /* @__PURE__ */ new Set(), ta = (e) => {
  ea.add(e);
}, fn = /* @__PURE__ */ new Set(), Qn = N(() => _e.value ? "The look-only lock is on." : pe.value === "watch" ? "You are watching. Ask for the pen to change things." : F.value.you ? null : `${F.value.name ?? "Somebody else"} has the pen. Take it to change things.`);
function Jn() {
  return U.value !== "open" ? "There is no connection to the program: nothing was changed." : Qn.value;
}
var Ji = (e) => (e.length > 120 ? `${e.slice(0, 119)}…` : e).replace(/[\u0000-\u001f]/g, " "), Be = class {
  constructor(t) {
    this.label = t;
  }
  label;
  waiting = null;
  touched = {};
  under = 0;
  last = 0;
  state = "new";
  /** A new value of the control. */
  set(t) {
    this.state === "over" || !this.begin() || (jo(t, 1 / 0), this.touched = an(this.touched, t), this.waiting = an(this.waiting ?? {}, t), this.under <= Oe.peek() && this.flush());
  }
  /** Any other message that belongs to this step. */
  also(t) {
    this.state === "over" || !this.begin() || (this.flush(), this.last = K(t));
  }
  end(t) {
    this.state === "held" && (this.flush(), Un(this.touched, this.last), this.finish({ do: "end", ...t ? { label: Ji(t) } : {} })), this.state = "over";
  }
  cancel() {
    this.state === "held" && (this.waiting = null, Un(this.touched, 0), this.finish({ do: "cancel" }), Et(0)), this.state = "over";
  }
  /** The server has followed so far. */
  followed() {
    this.waiting && this.under <= Oe.peek() && this.flush();
  }
  /** The line is gone, and with it what was held. */
  drop() {
    this.state = "over", fn.delete(this), It = 0;
  }
  begin() {
    if (this.state === "held") return !0;
    let t = re(Jn);
    return t ? (le(t, "warn"), this.state = "over", !1) : (this.state = "held", fn.add(this), It === 0 && ea.forEach((n) => n()), It++ === 0 && (this.last = K({ do: "begin", label: Ji(this.label) })), !0);
  }
  flush() {
    this.waiting && (this.under = this.last = K({ do: "set", patch: this.waiting }), this.waiting = null);
  }
  finish(t) {
    fn.delete(this), It = Math.max(0, It - 1), It === 0 && K(t);
  }
};
function Ve(e, t) {
  let n = new Be(e);
  n.set(t), n.end();
}
function Xs(e, t) {
  let n = new Be(e);
  n.also(t), n.end();
}
function At(e) {
  re(() => U.value) === "open" && (jo({ display: e }, 1 / 0), Un({ display: e }, K({ do: "display", patch: e })));
}
var Le = null;
function rr(e, t, n) {
  Le && Le.key !== e && Zi(), Le ??= { key: e, gesture: new Be(t), timer: 0 }, Le.gesture.set(n), clearTimeout(Le.timer), Le.timer = window.setTimeout(Zi, 700);
}
function Zi() {
  Le && (clearTimeout(Le.timer), Le.gesture.end(), Le = null);
}
T(() => {
  Oe.value, re(() => [...fn].forEach((e) => e.followed()));
});
T(() => {
  U.value !== "open" && [...fn].forEach((e) => e.drop());
});

// src/before.ts
var pn = g(null), de = g(null), Ys = g(0.5);
function Qs() {
  let e = W.peek(), t = Yi();
  e && t && (pn.value = { picture: t, camera: e.camera });
}
function ir() {
  de.peek() !== "wipe" && Qs();
}
ta(ir);
function na() {
  let e = pn.peek(), t = W.peek();
  if (!e || !t) le("Nothing has been changed yet.");
  else if (!nn(e.camera, t.camera)) le("The picture before was taken from another place: go back there with Alt+←.", "warn");
  else return !0;
  return !1;
}
function dn(e) {
  e ? de.peek() === null && na() && (de.value = "held") : de.peek() === "held" && (de.value = null);
}
function Js() {
  de.value = de.peek() === "wipe" ? null : na() ? "wipe" : null;
}

// src/select.ts
var P = g(null), me = g(null), G = g(null), Zs = g("move"), ue = N(() => {
  let e = P.value;
  return e?.kind === "lamp" ? e.ids.filter((t) => M.has(t)) : e?.kind === "group" ? e.ids.flatMap((t) => D.get(t)?.lamps ?? []) : [];
});
function Ge(e, t, n = "only") {
  let o = P.peek();
  if (n === "only" || o?.kind !== e) {
    P.value = { kind: e, ids: [t] };
    return;
  }
  let r = o.ids.includes(t);
  if (r && n === "add") return;
  let i = r ? o.ids.filter((a) => a !== t) : [...o.ids, t];
  P.value = i.length ? { kind: e, ids: i } : null;
}
function Zn() {
  P.value = null;
}
function oa(e, t, n) {
  let o = P.peek(), r = o?.kind === e ? t.indexOf(o.ids[o.ids.length - 1]) : -1;
  if (r < 0) return Ge(e, n);
  let i = t.indexOf(n), [a, s] = r < i ? [r, i] : [i, r], p = t.slice(a, s + 1), c = (o?.ids ?? []).filter((u) => !p.includes(u));
  P.value = { kind: e, ids: [...c, ...r < i ? p : p.reverse()] };
}
function el(e) {
  let t = P.peek(), n = t?.kind ?? "lamp", o = n === "lamp" ? M.ids.peek() : n === "thing" ? ye.ids.peek() : D.ids.peek();
  if (!o.length) return;
  let r = t ? o.indexOf(t.ids[t.ids.length - 1]) : e > 0 ? -1 : 0;
  Ge(n, o[(r + e + o.length) % o.length]);
}
function ra(e, t) {
  switch (e) {
    case "lamp":
      return M.get(t)?.name ?? `lamp ${t}`;
    case "group":
      return D.get(t)?.name ?? `group ${t}`;
    case "thing":
      return ye.get(t)?.name ?? `thing ${t}`;
    case "material":
      return xt.get(t)?.name ?? `material ${t}`;
    default:
      return `${e} ${t}`;
  }
}
function eo(e) {
  return e.length === 1 ? ra("lamp", e[0]) : `${e.length} lamps`;
}
function ia(e, t) {
  let n = [];
  if (e?.lamp != null) {
    n.push({ kind: "lamp", ids: [e.lamp] });
    let i = M.get(e.lamp)?.group;
    i != null && (D.get(i)?.lamps.length ?? 0) > 1 && n.push({ kind: "group", ids: [i] });
  }
  if (e?.thing != null && n.push({ kind: "thing", ids: [e.thing] }), !n.length) {
    t === "only" && Zn();
    return;
  }
  if (t !== "only") return Ge(n[0].kind, n[0].ids[0], t);
  let o = P.peek(), r = n.findIndex((i) => o?.kind === i.kind && o.ids.length === 1 && o.ids[0] === i.ids[0]);
  P.value = n[(r + 1) % n.length];
}
var to = g(null);

// src/navigate.ts
var tl = 1.6, he = g(null), sa = N(() => pe.value === "edit" && F.value.you), Ie = N(() => ee.value?.up ?? [0, 0, 1]), we = g([640, 480]), Kt = g(null), lr = null, mn = null, ar = !1, ze = [], cr = [], ur = 0;
function Q(e, t = null) {
  let n = he.peek();
  if (n && nn(n, e)) return;
  let o = performance.now();
  n && (o - ur > 1e3 || t) && (ze.push(n), ze.length > 100 && ze.shift(), cr.length = 0), ur = o, he.value = e, Kt.value = t;
}
var oe = () => he.peek();
function nl() {
  la(ze, cr);
}
function ol() {
  la(cr, ze);
}
function la(e, t) {
  let n = e.pop();
  if (!n) return;
  let o = he.peek();
  o && t.push(o), ur = performance.now(), he.value = n, Kt.value = null;
}
T(() => {
  !he.value || U.value !== "open" || !sa.value || ar || (ar = !0, requestAnimationFrame(() => {
    ar = !1;
    let t = he.peek();
    if (!t || mn && nn(mn, t)) return;
    let { eye: n, target: o, up: r, fov: i, height: a, near: s } = t, p = { do: "camera", eye: n, target: o, up: r, fov: i };
    a && (p.height = a), s && (p.near = s), K(p) && (mn = t);
  }));
});
T(() => {
  let e = W.value;
  e && re(() => {
    he.peek() && sa.peek() || (mn = e.camera, he.value = e.camera, lr ??= e.camera);
  });
});
Se("hello", () => mn = null);
function Ot(e, t) {
  let n = W.peek();
  if (!n) return null;
  let { head: o } = n, r = hn(o.width, o.height);
  return { frame: o.frame, x: (e - r.x) / r.scale, y: (t - r.y) / r.scale };
}
function hn(e, t) {
  let [n, o] = we.peek(), r = Math.min(n / e, o / t);
  return { x: (n - e * r) / 2, y: (o - t * r) / 2, scale: r };
}
function ft(e = he.peek()) {
  let [t, n] = we.peek();
  return e ? wt(e, t, n) : null;
}
var Ht = () => ee.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]], Dt = () => qe(Ht());
function no(e, t) {
  let n = oe();
  n && Q(Ei(n, Ie.peek(), e, t));
}
function oo(e, t, n) {
  let o = oe();
  o && Q($i(o, Ie.peek(), e, t, n));
}
function Ft(e, t, n) {
  let o = oe(), r = ft();
  o && r && Q(Li(o, r, e, t, n));
}
function ua(e, t, n) {
  let o = oe();
  if (o) {
    if (o.height) {
      let r = ft(o);
      r && Q(je(o, I(S(r.side, t), S(r.up, e))));
      return;
    }
    Jo.peek() === "fly" || n !== 0 ? Q(Pi(o, Ie.peek(), e, t, n)) : (Q(Ti(o, Ie.peek(), e, t, 0)), rl());
  }
}
var Rt = !1, sr = !0, aa = null;
function rl() {
  let e = oe();
  if (!e || Rt || !sr) return;
  let t = Ie.peek();
  Rt = !0;
  let n = Me("ray", { origin: e.eye, direction: S(t, -1) }, (o) => {
    Rt = !1, sr = !0;
    let r = oe();
    if (!o.hit || !r || r.height) return;
    aa = q(o.point, t);
    let i = aa + tl - q(r.eye, t);
    Math.abs(i) > 0.01 && Q(je(r, S(t, i * 0.5)));
  }, () => {
    Rt = !1, sr = !1;
  });
  setTimeout(() => {
    Rt && n(), Rt = !1;
  }, 500);
}
function il() {
  let e = P.peek();
  if (!e) return null;
  let t = [], n = (i, a) => {
    i ? t.push(i) : a && t.push([a, a]);
  };
  for (let i of e.ids)
    if (e.kind === "lamp" && n(M.get(i)?.box, M.get(i)?.place?.position), e.kind === "thing" && n(ye.get(i)?.box), e.kind === "meter" && n(null, Ct.get(i)?.point), e.kind === "group")
      for (let a of D.get(i)?.lamps ?? []) n(M.get(a)?.box, M.get(a)?.place?.position);
  if (!t.length) return null;
  let o = t.flatMap(_t), r = (i) => [0, 1, 2].map((a) => i(...o.map((s) => s[a])));
  return [r(Math.min), r(Math.max)];
}
function fr() {
  let e = oe(), t = il();
  e && t ? Q(Vi(e, t), "selection") : pr();
}
function pr() {
  lr && Q(lr, "home");
}
function al(e) {
  let [t, n] = we.peek();
  Q(Ai(e, Ht(), Ie.peek(), t / n), e);
}
function sl() {
  for (let e = ze.length - 1; e >= 0; e--)
    if (!ze[e].height) return Q(ze[e], "inside");
  pr();
}
var ll = N(() => {
  let e = he.value;
  if (!e?.height) return null;
  let t = wt(e, 2, 2), n = _t(Ht()).map((s) => q(O(s, e.eye), t.forward)), o = e.near ?? 0, r = q(t.forward, Ie.value), i = Math.min(..._t(Ht()).map((s) => q(s, Ie.value))), a = Math.abs(r) > 0.99 ? q(e.eye, Ie.value) + r * o - i : null;
  return { value: o, most: Math.max(...n), height: a };
});
function ul(e) {
  let t = oe();
  t && (he.value = { ...t, near: Math.max(0, e) });
}

// src/tools.ts
var dr = g("spot"), ca = () => {
}, cl = (e) => {
  ca = e;
}, fa = (e) => ca(e);
function mr(e) {
  G.value = G.peek() === e ? null : e;
}
var ro = (e) => Math.max(-1, ...e.ids.peek()) + 1;
function hr(e) {
  return e.kind === "sky" || e.kind === "parallel" ? null : e.place?.position ?? (e.box ? qe(e.box) : null);
}

// src/actions.ts
var pt = g(null), Ae = g("lamps"), gr = g("");
function ao(e) {
  let t = Jn();
  if (t) return le(t, "warn");
  (e.do === "look" ? e.what === "recall" : e.do !== "save") && ir(), K(e);
}
var fl = (e, t) => Object.fromEntries(e.map((n) => [n, t])), pl = {
  quantity: "illuminance",
  low: 1,
  high: 1e3,
  scale: "log",
  palette: "even",
  lines: !1
}, vr = pl, pa = ({ quantity: e, low: t, high: n, scale: o, palette: r, lines: i }) => ({ quantity: e, low: t, high: n, scale: o, palette: r, lines: i }), dl = () => at.peek().false_color ?? vr;
function br() {
  let e = at.peek().false_color;
  e && (vr = e), At({ false_color: e ? null : pa(vr) });
}
function so(e) {
  let t = Math.round(((at.peek().ev ?? 0) + e / 3) * 30) / 30;
  At({ ev: t });
}
function ml() {
  let e = oe();
  if (!e) return;
  let t = ro(St);
  Ve("Store the view", { views: { [t]: { ...e, name: `View ${t + 1}` } } });
}
var hl = () => ao({ do: "look", what: "store", name: `Look ${ro(Mt) + 1}` });
async function yr(e) {
  let t = !1;
  try {
    await navigator.clipboard.writeText(e), t = !0;
  } catch {
    let n = document.createElement("textarea");
    n.value = e, n.className = "spoken", document.body.append(n), n.select(), t = document.execCommand("copy"), n.remove();
  }
  le(t ? "Copied." : `Copy it by hand: ${e}`);
}
var Nt = /* @__PURE__ */ new Map(), io = null;
function vl(e) {
  Nt = new Map(e.map((t) => [t.id, t])), io && te(io), io = null;
}
var gl = () => [...Nt.values()], da = (e) => Nt.get(e), _r = (e) => Nt.get(e)?.why?.() ?? null;
function te(e) {
  let t = Nt.get(e);
  Nt.size || (io = e);
  let n = t?.why?.();
  n ? le(n, "warn") : t?.run();
}

// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var bl = /* @__PURE__ */ Symbol.for("pv"), yl = 0;
function l(e, t, n, o, r, i) {
  t || (t = {});
  var a, s, p = t;
  if ("ref" in p && typeof e != "function") for (s in p = {}, t) s == "ref" ? a = t[s] : p[s] = t[s];
  var c = { type: e, props: p, key: n, ref: a, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: bl, __v: --yl, __i: -1, __u: 0 };
  return (r || i) && (c.__source = r, c.__self = i), E.vnode && E.vnode(c), c;
}

// src/load.tsx
var ha = g(null), ma = !1, wr = (e) => ha.value?.[e];
function J({ part: e }) {
  let t = wr(e);
  return t ? l(t, {}) : null;
}
function va() {
  T(() => {
    if (ma || !(W.value ?? P.value)) return;
    ma = !0;
    let e = "./gizmo.js";
    setTimeout(() => {
      import(e).then((t) => ha.value = t);
    }, 0);
  });
}

// src/units.ts
var lo = 0.3048, ga = {
  level: { bare: 0.01, units: { "%": 0.01, x: 1, "×": 1 }, low: 0, high: 1e3, say: "a level such as 80 % or 450 lm" },
  flux: { bare: 1, units: { lm: 1, klm: 1e3 }, low: 0, high: 1e9, say: "a flux such as 450 lm" },
  kelvin: { bare: 1, units: { k: 1 }, low: 1e3, high: 25e3, say: "a colour temperature such as 2700 K" },
  angle: { bare: 1, units: { "°": 1, deg: 1, rad: 180 / Math.PI }, low: -36e3, high: 36e3, say: "an angle such as 30°" },
  length: {
    bare: 1,
    units: { m: 1, cm: 0.01, mm: 1e-3, km: 1e3, ft: lo, "'": lo, in: lo / 12, '"': lo / 12 },
    low: -1e6,
    high: 1e6,
    say: `a length such as 2.4 m, 75 cm or 8'2"`
  },
  lux: { bare: 1, units: { lx: 1, klx: 1e3, fc: 10.7639 }, low: 0, high: 1e9, say: "an illuminance such as 500 lx" },
  share: { bare: 1, units: { "%": 0.01 }, low: 0, high: 1, say: "a share from 0 to 1 or 0 to 100 %" },
  number: { bare: 1, units: {}, low: -1e9, high: 1e9, say: "a number" },
  ev: { bare: 1, units: { ev: 1, stop: 1, stops: 1 }, low: -30, high: 30, say: "an exposure such as 8.3" },
  seconds: { bare: 1, units: { s: 1, ms: 1e-3, min: 60 }, low: 0, high: 3600, say: "a time such as 2 s" }
}, _l = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;
function kr(e) {
  let t = _l.exec(e);
  if (!t) return null;
  let [n, o] = t[0].split("/").map(Number);
  return o === 0 ? null : { value: o === void 0 ? n : n / o, rest: e.slice(t[0].length).trimStart() };
}
function ba(e, t, n) {
  let o = e.trim(), r = 0, i = !0;
  for (; o; ) {
    let a = 1, s = /^[+-]\s*/.exec(o);
    s && !i && (a = o[0] === "-" ? -1 : 1, o = o.slice(s[0].length));
    let p = kr(o);
    if (!p) return null;
    let c = /^[a-zµ°%'"×]+/i.exec(p.rest)?.[0] ?? "", u = c === "" ? n : t.units[c.toLowerCase()];
    if (u === void 0) return null;
    r += a * p.value * u, o = p.rest.slice(c.length).trim(), i = !1;
  }
  return i ? null : r;
}
function ya(e, t, n) {
  let o = ga[t], r = e.trim().replace(/,(?=\d)/g, ".").replace(/[\u2009\u202f\u00a0]/g, "").replace(/−/g, "-"), i = { why: `“${e.trim()}” is not ${o.say}` }, a = (y) => ({
    apply: (w) => Math.min(o.high, Math.max(o.low, y(w)))
  });
  if (!r) return { why: `Type ${o.say}` };
  let s = r.toLowerCase();
  if (t === "level" && s === "full") return a(() => 1);
  if (t === "level" && (s === "out" || s === "off")) return a(() => 0);
  let p = /^(.*?)\s*(?:stops?|ev)$/i.exec(r);
  if (p && t !== "ev") {
    let y = kr(p[1].trim());
    return !y || y.rest || !["level", "flux", "lux", "number"].includes(t) ? i : a((w) => w * 2 ** y.value);
  }
  let c = /^([*/×÷])\s*(.+)$/.exec(r);
  if (c) {
    let y = kr(c[2]);
    if (!y) return i;
    let w = y.rest === "%" ? 0.01 : y.rest === "" ? 1 : NaN, x = y.value * w;
    return !Number.isFinite(x) || x === 0 && /[/÷]/.test(c[1]) ? i : a((k) => /[/÷]/.test(c[1]) ? k / x : k * x);
  }
  let d = t === "length" || t === "angle" || t === "ev" || t === "number" ? /^([+-])=\s*(.+)$/.exec(r) : /^([+-])=?\s*(.+)$/.exec(r), m = d ? d[2] : r, f = ba(m, o, o.bare);
  if (f === null && t === "level" && n) {
    let y = ba(m, { ...ga.flux }, NaN);
    f = y === null || Number.isNaN(y) ? null : y / n;
  }
  if (f === null || !Number.isFinite(f)) return i;
  let b = f;
  return d ? a((y) => d[1] === "-" ? y - b : y + b) : b < o.low || b > o.high ? { why: `${e.trim()} is out of range: ${o.say}` } : a(() => b);
}
function B(e, t = 0) {
  if (!Number.isFinite(e)) return "–";
  let [n, o] = Math.abs(e).toFixed(t).split("."), r = n.length > 4 ? n.replace(/\B(?=(\d{3})+$)/g, " ") : n;
  return (e < 0 && Number(Math.abs(e).toFixed(t)) !== 0 ? "−" : "") + r + (o ? `.${o}` : "");
}
function Xe(e) {
  let t = Math.abs(e);
  return B(e, t >= 99.95 || t === 0 ? 0 : t >= 9.995 ? 1 : t >= 0.9995 ? 2 : 3);
}
function Re(e) {
  let t = e * 100;
  return B(t, t >= 9.95 || t === 0 ? 0 : t >= 0.95 ? 1 : 2);
}
function vn(e, t) {
  switch (t) {
    case "level":
      return `${Re(e)} %`;
    case "flux":
      return `${Xe(e)} lm`;
    case "kelvin":
      return `${B(e)} K`;
    case "angle":
      return `${B(e, 1)}°`;
    case "length":
      return `${B(e, 2)} m`;
    case "lux":
      return `${Xe(e)} lx`;
    case "seconds":
      return `${B(e, 1)} s`;
    case "ev":
      return B(e, 1);
    case "share":
      return B(e, 2);
    case "number":
      return String(Math.round(e * 1e4) / 1e4);
  }
}
function dt(e, t = !0) {
  let n = Vt.value === "fc", o = n ? e / 10.7639 : e;
  return Xe(o) + (t ? n ? " fc" : " lx" : "");
}

// src/field.tsx
function gn(e) {
  let t = nt(null), n = nt(null), o = ne(null), r = ne(null), i = t.value ?? e.text ?? (e.value === null ? "mixed" : vn(e.value, e.quantity));
  Ee(() => {
    !e.open || !o.current || (t.value = e.open, o.current.focus(), o.current.setSelectionRange(e.open.length, e.open.length), e.opened?.());
  }, [e.open]);
  let a = () => {
    if (t.value === null) return;
    let d = ya(t.value, e.quantity, e.flux);
    if ("why" in d) {
      n.value = d.why;
      return;
    }
    t.value = null, n.value = null, e.set(d.apply);
  }, s = (d) => {
    if (d.key === "Enter")
      d.preventDefault(), a(), t.value === null && o.current?.select();
    else if (d.key === "Escape")
      d.stopPropagation(), t.value === null && o.current?.blur(), t.value = null, n.value = null;
    else if ((d.key === "ArrowUp" || d.key === "ArrowDown") && e.step && t.value === null) {
      d.preventDefault();
      let m = (d.key === "ArrowUp" ? 1 : -1) * e.step * (d.shiftKey ? 10 : d.ctrlKey ? 0.1 : 1);
      e.set((f) => f + m);
    }
  }, p = (d) => {
    !e.scrub || e.disabled || d.button !== 0 || document.activeElement === o.current || (r.current = { x: d.clientX, last: d.clientX, moved: !1 }, o.current?.setPointerCapture(d.pointerId), d.preventDefault());
  }, c = (d) => {
    let m = r.current;
    !m || !e.scrub || !m.moved && Math.abs(d.clientX - m.x) < 4 || (m.moved || e.scrub.begin(), m.moved = !0, e.scrub.on((d.clientX - m.last) * (e.step ?? 1) * (d.shiftKey ? 0.1 : d.altKey ? 10 : 1)), m.last = d.clientX);
  }, u = (d) => {
    let m = r.current;
    r.current = null, m && (m.moved ? d.type === "pointercancel" ? e.scrub?.cancel() : e.scrub?.end() : (o.current?.focus(), o.current?.select()));
  };
  return l("span", { class: `field ${n.value ? "wrong" : ""} ${e.scrub ? "scrubs" : ""}`, children: [
    l(
      "input",
      {
        ref: o,
        id: e.id,
        tabIndex: e.tabIndex,
        type: "text",
        inputMode: "text",
        autoComplete: "off",
        spellcheck: !1,
        value: i,
        disabled: e.disabled,
        title: e.why ?? void 0,
        "aria-label": e.label,
        "aria-invalid": n.value ? !0 : void 0,
        "aria-errormessage": n.value ? `${e.id ?? e.label}-why`.replace(/\s/g, "-") : void 0,
        onInput: (d) => {
          t.value = d.currentTarget.value, n.value = null;
        },
        onFocus: (d) => t.value === null && d.currentTarget.select(),
        onBlur: () => {
          a(), n.value && (t.value = null, setTimeout(() => n.value = null, 4e3));
        },
        onKeyDown: s,
        onPointerDown: p,
        onPointerMove: c,
        onPointerUp: u,
        onPointerCancel: u
      }
    ),
    n.value && l("span", { class: "why", role: "alert", id: `${e.id ?? e.label}-why`.replace(/\s/g, "-"), children: n.value })
  ] });
}

// src/icon.tsx
function z({ name: e }) {
  return l("svg", { class: "sign", "aria-hidden": "true", width: "16", height: "16", children: l("use", { href: `icons.svg#${e}` }) });
}

// src/menu.tsx
function qt({ id: e, label: t, title: n, children: o }) {
  let r = (a) => {
    let s = document.getElementById(e), p = a.getBoundingClientRect();
    s?.style.setProperty("left", `${Math.max(8, Math.min(p.left, innerWidth - 296))}px`), s?.style.setProperty("top", `${p.bottom + 4}px`);
  };
  return l(X, { children: [
    l("button", { ...{ popovertarget: e }, title: n, "aria-label": n, "aria-haspopup": "true", onPointerDown: (a) => r(a.currentTarget), onFocus: (a) => r(a.currentTarget), children: t }),
    l("div", { id: e, popover: "auto", class: "menu", children: o })
  ] });
}
function xr({ id: e, label: t }) {
  let n = _r(e), o = da(e);
  return l(
    "button",
    {
      class: "item",
      "aria-disabled": n !== null,
      title: n ?? void 0,
      onClick: (r) => {
        r.currentTarget.closest("[popover]")?.hidePopover(), te(e);
      },
      children: [
        l("span", { children: t ?? o?.label }),
        l("kbd", { children: o?.keys })
      ]
    }
  );
}

// src/bar.tsx
var _a = {
  clean: "nothing changed",
  saved: "saved",
  waiting: "saving…",
  failed: "not saved"
};
function wa() {
  let e = at.value, t = rt.value.undo, n = rt.value.redo, o = it.value, r = e.metered;
  return l("header", { class: "bar", children: [
    l(qt, { id: "page-menu", label: l(z, { name: "menu" }), title: "Page", children: l(J, { part: "PageItems" }) }),
    l("h1", { title: o.file || ee.value?.file, children: [
      ee.value?.name ?? "Lampyris",
      l("i", { class: `dot ${o.state}`, role: "img", "aria-label": _a[o.state], title: `${_a[o.state]}${o.file ? `: ${o.file}` : ""}` })
    ] }),
    l("span", { class: "group", children: [
      l("button", { class: "icon", "aria-label": t ? `Undo: ${t}` : "Undo", title: t ? `Undo: ${t} (Ctrl+Z)` : "Nothing to undo", "aria-disabled": t === null, onClick: () => te("undo"), children: l(z, { name: "undo" }) }),
      l("button", { class: "icon", "aria-label": n ? `Redo: ${n}` : "Redo", title: n ? `Redo: ${n} (Ctrl+Shift+Z)` : "Nothing to redo", "aria-disabled": n === null, onClick: () => te("redo"), children: l(z, { name: "redo" }) })
    ] }),
    l(qt, { id: "view-menu", label: l(X, { children: [
      "View ",
      l(z, { name: "down" })
    ] }), title: "View", children: l(J, { part: "ViewItems" }) }),
    l("span", { class: "group wide", children: [
      l("button", { "aria-pressed": !1, onClick: () => te("preset-plan"), title: "Plan (Shift+1)", children: "Plan" }),
      l("button", { onClick: () => te("inside"), title: "Inside (Shift+0)", children: "Inside" })
    ] }),
    l("span", { class: "gap" }),
    l(qt, { id: "seeing-menu", label: l(X, { children: [
      "Picture ",
      l(z, { name: "down" })
    ] }), title: "Picture: tone, white, figures", children: l(J, { part: "SeeingItems" }) }),
    l("button", { "aria-pressed": e.false_color !== null, onClick: br, title: "False colour (B)", children: "False colour" }),
    l("button", { "aria-pressed": de.value === "wipe", "aria-disabled": pn.value === null, onClick: () => te("wipe"), title: "Wipe between before and now (C); hold \\ to see before", children: "Compare" }),
    l("span", { class: "group exposure", role: "group", "aria-label": "Exposure", children: [
      l("button", { class: "icon", "aria-label": "Darker", title: "Darker by ⅓ (,)", onClick: () => so(1), children: l(z, { name: "minus" }) }),
      l("label", { children: [
        l("span", { "aria-hidden": "true", children: "EV" }),
        l(gn, { label: "Exposure value", quantity: "ev", value: e.ev ?? 0, step: 1 / 3, set: (i) => At({ ev: i(e.ev ?? 0) }) })
      ] }),
      l("button", { class: "icon", "aria-label": "Brighter", title: "Brighter by ⅓ (.)", onClick: () => so(-1), children: l(z, { name: "plus" }) }),
      l("button", { class: "icon", "aria-label": "Meter once", title: `${r ? "As metered" : "Meter once"} (/); it stays locked`, onClick: () => K({ do: "expose" }), children: l(z, { name: r ? "lock" : "meter" }) })
    ] }),
    l(
      "button",
      {
        class: "icon look-lock",
        "aria-pressed": _e.value,
        "aria-label": "Look-only lock",
        title: "Look-only lock: no finger changes anything",
        onClick: () => _e.value = !_e.value,
        children: l(z, { name: _e.value ? "lock" : "unlock" })
      }
    ),
    pe.value === "edit" && l("button", { class: "wide", onClick: () => pt.value = "share", children: "Share" }),
    l("button", { class: "icon", "aria-label": "All keys", title: "All keys (?)", onClick: () => pt.value = "help", children: l(z, { name: "help" }) }),
    l("button", { class: "icon", "aria-label": "Command palette", title: "Command palette (Ctrl+K)", onClick: () => pt.value = "palette", children: l(z, { name: "search" }) }),
    l(
      "button",
      {
        class: "icon narrow",
        "aria-label": Ae.value === "inspector" ? "Lamps" : "Inspector",
        title: Ae.value === "inspector" ? "Lamps" : "Inspector",
        onClick: () => Ae.value = Ae.value === "inspector" ? "lamps" : "inspector",
        children: l(z, { name: Ae.value === "inspector" ? "lamps" : "sliders" })
      }
    )
  ] });
}

// src/highlight.ts
function uo(e) {
  xe.value = e, K({ do: "solo", lamps: e });
}
function Sr(e) {
  let t = xe.peek(), n = e.every((o) => t.includes(o));
  uo(n ? t.filter((o) => !e.includes(o)) : [...t, ...e.filter((o) => !t.includes(o))]);
}
var wl = () => Sr(ue.peek()), Mr = () => uo([]), bn = null;
function co(e) {
  e && bn === null && ue.peek().length ? (bn = xe.peek(), uo(ue.peek())) : !e && bn !== null && (uo(bn), bn = null);
}

// src/lights.ts
var Ye = g(null), Cr = () => {
}, xa = () => {
};
function fo(e, t, n) {
  po(), Ye.value = { x: e, y: t, hit: n, lux: n.lux, lamps: [], done: !1 }, ka(n);
  let o = !0, r = 0;
  xa = T(() => {
    for (let [, i] of M.all()) st(i);
    if (o) {
      o = !1;
      return;
    }
    clearTimeout(r), r = window.setTimeout(() => {
      let i = re(() => Ye.value);
      i && ka(i.hit);
    }, 250);
  });
}
function ka(e) {
  Cr(), Cr = Me("light", { point: e.point, normal: e.normal }, (t) => {
    let n = Ye.peek();
    n && (Ye.value = {
      ...n,
      lux: t.lux ?? n.lux,
      lamps: t.lamps ?? n.lamps,
      done: t.done !== !1
    });
  });
}
function po() {
  Cr(), xa(), Ye.value = null;
}

// src/keys.ts
var La = g("W A S D"), Er = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyA: [0, -1, 0],
  KeyD: [0, 1, 0],
  KeyQ: [0, 0, -1],
  KeyE: [0, 0, 1]
}, kl = 1.8, jt = /* @__PURE__ */ new Set(), mo = !1, ho = 1, Tr = !1, Pr = 0;
function Va(e) {
  let t = Math.min(0.1, Math.max(0, (e - Pr) / 1e3));
  if (Pr = e, !jt.size) {
    Tr = !1;
    return;
  }
  let [n, o, r] = [0, 0, 0];
  for (let s of jt) {
    let [p, c, u] = Er[s];
    n += p, o += c, r += u;
  }
  let i = Math.max(1, Ke(...Ht()) / 12), a = kl * t * ho * Math.min(i, 6);
  (n || o || r) && ua(n * a, o * a, r * a), requestAnimationFrame(Va);
}
function yn(e) {
  jt.add(e), !Tr && (Tr = !0, Pr = performance.now(), requestAnimationFrame(Va));
}
var Sa = (e) => e instanceof HTMLElement && (e.isContentEditable || e.matches("input, textarea, select") && !e.matches("[type=range], [type=checkbox], [type=radio]"));
function Ma() {
  let e = document.activeElement;
  return e === null || e === document.body || e.id === "view";
}
var xl = {
  f: "frame",
  t: "aim",
  g: "move",
  r: "turn",
  n: "add-spot",
  o: "on-off",
  i: "solo",
  h: "hide",
  b: "false-colour",
  u: "panels",
  c: "wipe",
  m: "marquee",
  v: "walking",
  p: "meter",
  "[": "previous",
  "]": "next",
  "?": "help",
  delete: "remove",
  home: "home"
}, Ca = {
  b: "quantity",
  o: "park",
  i: "unsolo",
  l: "from-lamp",
  g: "grid",
  t: "aim-here",
  n: "place"
}, Ea = { Comma: "darker", Period: "brighter", Slash: "expose" }, Ta = {
  Digit1: "preset-plan",
  Digit2: "preset-ceiling",
  Digit3: "preset-north",
  Digit4: "preset-east",
  Digit5: "preset-south",
  Digit6: "preset-west",
  Digit0: "inside"
};
function Sl(e) {
  let t = e.key.toLowerCase();
  return t === "z" ? e.shiftKey ? "redo" : "undo" : t === "y" ? "redo" : t === "k" ? "palette" : t === "s" ? e.shiftKey ? "picture" : "save" : t === "d" ? "duplicate" : t === "g" ? e.shiftKey ? "ungroup" : "group" : t === "a" ? "all-lamps" : t === "enter" ? "look-store" : null;
}
function Ml() {
  G.peek() ? G.value = null : Ye.peek() ? po() : de.peek() ? de.value = null : P.peek() ? Zn() : document.activeElement?.id === "view" && document.querySelector('.bar button, .bar [tabindex="0"]')?.focus();
}
function Pa(e) {
  let [t, n] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
  return !t && !n ? !1 : (e.ctrlKey || oe()?.height ? Ft(-t * 24, n * 24, 3) : e.shiftKey ? oo(Dt(), -t * 0.05, n * 0.05) : no(-t * 0.06, n * 0.06), !0);
}
function $a(e) {
  let t = oe(), n = ft();
  !t || !n || (t.height ? Q(Fn(t, n, n.width / 2, n.height / 2, e)) : Q(Dn(t, t.target, e, 0.3, !0)));
}
var Ia = () => !1, Cl = (e) => {
  Ia = e;
};
function El(e) {
  if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
  if (!Sa(e.target) && Ia(e)) return e.preventDefault();
  let t = e.ctrlKey || e.metaKey;
  if (e.key === "Escape") return Ml();
  if (Sa(e.target)) {
    t && e.key.toLowerCase() === "k" && De(e, "palette");
    return;
  }
  if (t && !e.altKey) {
    if (Ma() && Pa(e)) return e.preventDefault();
    let i = Sl(e);
    i && De(e, i);
    return;
  }
  if (e.altKey) {
    let i = /^Digit(\d)$/.exec(e.code)?.[1];
    if (e.key === "ArrowLeft") return De(e, "back");
    if (e.key === "ArrowRight") return De(e, "forth");
    if (i === "0") return De(e, "store-view");
    if (i) {
      e.preventDefault();
      let a = St.all()[Number(i) - 1];
      a && Q(a[1], a[1].name ?? "view");
      return;
    }
    if (e.code === "KeyH" && De(e, "unhide"), !(e.code in Er)) return;
  }
  let n = Ma();
  if (n && Pa(e)) return e.preventDefault();
  if (n && e.code in Er)
    return ho = e.shiftKey ? 4 : e.altKey ? 0.25 : 1, yn(e.code), e.preventDefault();
  if (n && (e.key === "+" || e.key === "=")) return $a(0.85);
  if (n && (e.key === "-" || e.key === "_")) return $a(1 / 0.85);
  if (!er.peek()) return;
  if (e.shiftKey && Ta[e.code]) return De(e, Ta[e.code]);
  if (mo && /^\d$/.test(e.key)) {
    e.preventDefault(), mo = !1;
    let i = Mt.ids.peek()[Number(e.key) - 1];
    i !== void 0 && ao({ do: "look", id: i, what: "recall", seconds: nr.peek() });
    return;
  }
  if (mo = e.key.toLowerCase() === "j", mo) return le("Recall a look: now its digit.");
  if (!e.shiftKey && /^\d$/.test(e.key) && ue.peek().length) {
    e.preventDefault(), gr.value = e.key;
    return;
  }
  if (!e.shiftKey && e.key !== "?" && Ea[e.code]) return De(e, Ea[e.code]);
  if (e.key === "\\") return void (e.repeat || dn(!0));
  let o = e.key.toLowerCase();
  if (o === "l" && !e.shiftKey) return void (e.repeat || te("highlight"));
  if (o === "p" && e.shiftKey) return Tl();
  let r = e.shiftKey && Ca[o] ? Ca[o] : xl[o];
  r && !(e.target instanceof HTMLButtonElement && o === "enter") && De(e, r);
}
function Tl() {
  let [e, t] = we.peek(), n = Ot(e / 2, t / 2);
  n && Me("point", n, (o) => o.hit && fo(e / 2, t / 2, o));
}
function De(e, t) {
  e.preventDefault(), te(t);
}
function Pl(e) {
  jt.delete(e.code), e.key === "\\" && dn(!1), e.key.toLowerCase() === "l" && co(!1), e.key === "Shift" && (ho = 1);
}
function Aa() {
  addEventListener("keydown", El), addEventListener("keyup", Pl), addEventListener("blur", () => {
    jt.clear(), co(!1), dn(!1);
  }), navigator.keyboard?.getLayoutMap().then((t) => {
    La.value = ["KeyW", "KeyA", "KeyS", "KeyD"].map((n) => (t.get(n) ?? n.slice(3)).toUpperCase()).join(" ");
  }).catch(() => {
  });
}
function $l(e, t) {
  for (let n of ["KeyW", "KeyS", "KeyA", "KeyD"]) jt.delete(n);
  ho = Math.min(1, Math.hypot(e, t)), e > 0.2 && yn("KeyW"), e < -0.2 && yn("KeyS"), t < -0.2 && yn("KeyA"), t > 0.2 && yn("KeyD");
}

// src/levels.ts
var $r = (e) => Math.min(1, Yn.value === "square" ? Math.sqrt(Math.max(e, 0)) : e), Lr = (e) => {
  let t = Yn.peek() === "square" ? e * e : e;
  return Math.round(t * 1e3) / 1e3;
}, Ll = (e) => (e.kind === "lamp" ? M.get(e.id) : D.get(e.id))?.level ?? 0, vo = (e) => (e.kind === "lamp" ? M.get(e.id) : D.get(e.id))?.name ?? "";
function Vr(e) {
  let t = ue.peek();
  return e.kind === "lamp" && P.peek()?.kind === "lamp" && t.length > 1 && t.includes(e.id) ? t : [e.id];
}
function Ra(e, t, n) {
  if (e.kind === "group") return { groups: { [e.id]: { level: t } } };
  let o = n.get(e.id) ?? 0, r = {};
  for (let [i, a] of n) {
    let s = i === e.id ? t : o > 0 ? Math.min(10, a * (t / o)) : t;
    r[i] = { level: Math.round(s * 1e3) / 1e3 };
  }
  return { lamps: r };
}
var _n = class {
  constructor(t) {
    this.strip = t;
    this.was = this.now = Ll(t), this.from = t.kind === "lamp" ? new Map(Vr(t).map((n) => [n, M.get(n)?.level ?? 0])) : /* @__PURE__ */ new Map(), this.gesture = new Be(`${vo(t)} level`);
  }
  strip;
  gesture;
  from;
  was;
  now;
  to(t) {
    this.now = t, this.gesture.set(Ra(this.strip, t, this.from));
  }
  end() {
    let t = this.from.size > 1 ? eo([...this.from.keys()]) : vo(this.strip);
    this.gesture.end(`${t} ${Re(this.was)} → ${Re(this.now)} %`);
  }
  cancel() {
    this.gesture.cancel();
  }
};
function go(e, t) {
  let n = new Map(Vr(e).map((o) => [o, M.get(o)?.level ?? 0]));
  rr(`level ${e.kind} ${e.id}`, `${vo(e)} level`, Ra(e, t, n));
}
function Ir(e, t) {
  if (!e.length) return;
  let n = Object.fromEntries(e.map((r) => {
    let i = M.get(r);
    return [r, { level: t(i?.level ?? 0, i?.flux ?? 1) }];
  })), o = e.length === 1 ? ` ${Re(M.get(e[0])?.level ?? 0)} → ${Re(n[e[0]].level)} %` : " level";
  Ve(`${eo(e)}${o}`, { lamps: n });
}
function Ar(e, t) {
  let n = t(D.get(e)?.level ?? 0);
  Ve(`${D.get(e)?.name ?? "Group"} ${Re(n)} %`, { groups: { [e]: { level: n } } });
}
function Rr(e, t) {
  let n = `${vo(e)} ${t ? "on" : "off"}`;
  e.kind === "group" ? Ve(n, { groups: { [e.id]: { on: t } } }) : Ve(n, { lamps: Object.fromEntries(Vr(e).map((o) => [o, { on: t }])) });
}

// src/swatch.ts
var Vl = (e) => e <= 31308e-7 ? 12.92 * e : 1.055 * e ** 0.4166666666666667 - 0.055, Il = (e) => e <= 0.04045 ? e / 12.92 : ((e + 0.055) / 1.055) ** 2.4, Al = (e) => Math.round(255 * Vl(Math.max(0, Math.min(1, e))));
function Hr(e) {
  let t = Math.max(...e, 1e-6);
  return Ha(e.map((n) => n / t));
}
function Ha(e) {
  return `#${e.map((t) => Al(t).toString(16).padStart(2, "0")).join("")}`;
}
function Rl(e) {
  let t = (n) => Il(parseInt(e.slice(1 + 2 * n, 3 + 2 * n), 16) / 255);
  return [t(0), t(1), t(2)];
}
var Hl = (e) => 1e6 / e;

// src/range.tsx
var Ka = -1e9;
addEventListener("scroll", () => Ka = performance.now(), { capture: !0, passive: !0 });
var Ut = (e) => Math.max(0, Math.min(1, e));
function Kr(e) {
  let t = ne(null), n = ne(null), o = e.notch ?? 0.01, r = (c) => {
    if (c.button !== 0 || e.disabled) return;
    let u = c.currentTarget.getBoundingClientRect(), d = e.vertical ? (u.bottom - c.clientY - 8) / (u.height - 16) : (c.clientX - u.left - 6) / (u.width - 12), m = c.pointerType !== "touch" && !c.shiftKey;
    n.current = { id: c.pointerId, x: c.clientX, y: c.clientY, at: m ? Ut(d) : e.value }, t.current?.setPointerCapture(c.pointerId), t.current?.focus(), e.begin?.(), m && e.on(Ut(d));
  }, i = (c) => {
    let u = n.current;
    if (!u || u.id !== c.pointerId) return;
    let d = c.currentTarget.getBoundingClientRect(), m = e.vertical ? (u.y - c.clientY) / (d.height - 16) : (c.clientX - u.x) / (d.width - 12);
    u.x = c.clientX, u.y = c.clientY, u.at += m * (c.shiftKey ? 0.1 : 1), e.on(Ut(u.at));
  }, a = (c) => {
    n.current?.id === c.pointerId && (n.current = null, c.type === "pointercancel" ? e.cancel?.() : e.end?.());
  }, s = (c) => {
    if (c.key === "Escape" && n.current) {
      n.current = null, e.cancel?.(), c.stopPropagation();
      return;
    }
    let u = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[c.key], d = null;
    u && (d = Ut(e.value + u * o * (c.shiftKey ? 10 : 1))), c.key === "Home" && (d = 0), c.key === "End" && (d = 1), !(d === null || c.altKey || c.ctrlKey || c.metaKey) && (c.preventDefault(), c.stopPropagation(), e.on(d));
  }, p = (c) => {
    if (performance.now() - Ka < 400 || c.ctrlKey) return;
    c.preventDefault();
    let u = Math.abs(c.deltaY) >= Math.abs(c.deltaX) ? c.deltaY : c.deltaX;
    u && e.on(Ut(e.value - Math.sign(u) * o * (c.shiftKey ? 0.2 : 1)));
  };
  return l(
    "input",
    {
      ref: t,
      type: "range",
      id: e.id,
      class: `range ${e.class ?? ""} ${e.vertical ? "upright" : ""}`,
      min: 0,
      max: 1,
      step: "any",
      value: e.value,
      disabled: e.disabled,
      "aria-label": e.label,
      "aria-valuetext": e.text,
      style: { "--t": Ut(e.value), "--gradient": e.gradient ?? "" },
      onPointerDown: r,
      onPointerMove: i,
      onPointerUp: a,
      onPointerCancel: a,
      onMouseDown: (c) => c.preventDefault(),
      onTouchStart: (c) => c.cancelable && c.preventDefault(),
      onKeyDown: s,
      onWheel: p,
      onDblClick: () => e.reset?.(),
      onInput: (c) => {
        n.current ? c.currentTarget.value = String(e.value) : e.on(Number(c.currentTarget.value));
      }
    }
  );
}

// src/faderrow.tsx
function Oa(e) {
  let t = e.color;
  return t.mode === "kelvin" ? `${B(t.kelvin)} K` : t.mode === "rgb" ? "RGB" : t.mode === "xy" ? "x y" : "file";
}
var Or = (e) => e.free ? "re-mix: level and colour cost no ray" : "re-trace: its light is traced anew";
function Da({ row: e, index: t, count: n }) {
  let o = ne(null), r = { kind: e.kind, id: e.id }, i = e.kind === "lamp" ? M.get(e.id) : void 0, a = e.kind === "group" ? D.get(e.id) : void 0, s = i ?? a;
  if (!s) return null;
  let p = a?.lamps ?? [e.id], c = i ? i.flux : p.reduce((_, C) => _ + (M.get(C)?.flux ?? 0) * (M.get(C)?.level ?? 0), 0), u = Uo(p), d = P.value?.kind === e.kind && P.value.ids.includes(e.id), m = p.length > 0 && p.every((_) => xe.value.includes(_)), f = xe.value.length > 0 && !p.some((_) => xe.value.includes(_)), b = me.value?.kind === e.kind && me.value.id === e.id, y = `${d ? "selected" : ""} ${s.on && !i?.parked ? "" : "off"} ${f ? "muted" : ""} ${b ? "under" : ""}`, w = Qn.value, x = d ? 0 : -1, k = {
    begin: () => o.current = new _n(r),
    end: () => {
      o.current?.end(), o.current = null;
    },
    cancel: () => {
      o.current?.cancel(), o.current = null;
    }
  };
  return l(
    "div",
    {
      class: `fader-row depth-${e.depth} ${e.kind} ${y}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => me.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => me.value = null,
      children: [
        l("button", { class: "icon power", tabIndex: x, "aria-pressed": s.on, disabled: w !== null, "aria-label": `${s.name} on`, title: w ?? (s.on ? "On (O)" : "Off (O)"), onClick: () => Rr(r, !s.on), children: l(z, { name: "power" }) }),
        l("div", { class: "top", children: [
          a && l("button", { class: "icon fold", "aria-expanded": !mt.value.has(e.id), "aria-label": `Members of ${s.name}`, onClick: () => Fa(e.id), children: l(z, { name: mt.value.has(e.id) ? "right" : "down" }) }),
          l("button", { class: "row-name", "aria-pressed": d, title: i ? `${i.name}: ${Or(i)}` : s.name, onClick: (_) => Dr(_, e.kind, e.id), children: [
            l("span", { children: s.name }),
            a && l("small", { children: p.length }),
            i?.parked && l("small", { children: "parked" }),
            i && !i.free && l("small", { class: "traced", title: Or(i), children: [
              "↻",
              l("span", { class: "spoken", children: "re-trace" })
            ] })
          ] }),
          i && l("span", { class: "tint", children: [
            l("i", { class: "swatch", style: { background: Hr(i.swatch) } }),
            Oa(i)
          ] }),
          l("button", { class: "icon solo", tabIndex: x, "aria-pressed": m, "aria-label": `Solo ${s.name}`, title: "Solo (I)", onClick: () => Sr(p), children: l(z, { name: "solo" }) })
        ] }),
        l("div", { class: "bottom", children: [
          l(
            Kr,
            {
              label: `${s.name} level`,
              class: "level",
              value: $r(s.level),
              text: `${Re(s.level)} %, ${Xe(u)} lumen`,
              notch: 0.01,
              disabled: w !== null,
              on: (_) => {
                let C = Lr(_);
                o.current ? o.current.to(C) : go(r, C);
              },
              reset: () => go(r, 1),
              ...k
            }
          ),
          l(
            gn,
            {
              label: `${s.name} level, typed`,
              quantity: "level",
              value: s.level,
              flux: c,
              step: 0.01,
              disabled: w !== null,
              why: w,
              tabIndex: x,
              set: (_) => i ? Ir(d && ue.peek().length > 1 ? ue.peek() : [e.id], _) : Ar(e.id, _)
            }
          ),
          l("span", { class: "lumens", children: vn(u, "flux") })
        ] })
      ]
    }
  );
}

// src/virtual.tsx
var Na = 4;
function Fr({ count: e, height: t, row: n, label: o, show: r, role: i = "list" }) {
  let a = ne(null), s = nt(0), p = nt(600);
  Ee(() => {
    let d = a.current, m = new ResizeObserver(() => p.value = d.clientHeight);
    return m.observe(d), () => m.disconnect();
  }, []), Ee(() => {
    let d = a.current;
    if (!d || r === void 0 || r < 0) return;
    let m = r * t;
    (m < d.scrollTop || m + t > d.scrollTop + d.clientHeight) && (d.scrollTop = Math.max(0, m - d.clientHeight / 2));
  }, [r, t]);
  let c = Math.max(0, Math.floor(s.value / t) - Na), u = Math.min(e, Math.ceil((s.value + p.value) / t) + Na);
  return l("div", { class: "virtual", ref: a, tabIndex: e ? void 0 : -1, onScroll: (d) => s.value = d.currentTarget.scrollTop, children: l("div", { class: "all", role: i, "aria-label": o, style: { height: `${e * t}px` }, children: l("div", { class: "rows", role: "presentation", style: { transform: `translateY(${c * t}px)` }, children: Array.from({ length: Math.max(0, u - c) }, (d, m) => n(c + m)) }) }) });
}

// src/lamps.tsx
var bo = g(""), mt = g(/* @__PURE__ */ new Set()), yo = g("group"), ja = N(() => {
  let e = bo.value.trim().toLowerCase(), t = M.listed(), n = D.listed(), o = new Map(n.map(([s, p]) => [s, p.name])), r = new Map(t.filter(([, s]) => !e || `${s.name} ${s.kind} ${o.get(s.group ?? -1) ?? ""}`.toLowerCase().includes(e)));
  if (yo.value !== "group" && Lt.value === "sheet") {
    let s = yo.value, p = [...r];
    return p.sort(([, c], [, u]) => s === "name" ? c.name.localeCompare(u.name, "en", { numeric: !0 }) : u[s] - c[s]), p.map(([c]) => ({ kind: "lamp", id: c, depth: 0 }));
  }
  let i = [], a = /* @__PURE__ */ new Set();
  for (let [s, p] of n) {
    p.lamps.forEach((u) => a.add(u));
    let c = p.lamps.filter((u) => r.has(u));
    if (c.length) {
      if (p.lamps.length === 1) {
        i.push({ kind: "lamp", id: c[0], depth: 0 });
        continue;
      }
      i.push({ kind: "group", id: s, depth: 0 }), (!mt.value.has(s) || e) && c.forEach((u) => i.push({ kind: "lamp", id: u, depth: 1 }));
    }
  }
  for (let [s] of r) a.has(s) || i.push({ kind: "lamp", id: s, depth: 0 });
  return i;
}), qa = !1;
D.ids.subscribe((e) => {
  qa || !e.length || (qa = !0, M.ids.peek().length > 40 && (mt.value = new Set(e.filter((t) => (D.get(t)?.lamps.length ?? 0) > 1))));
});
function Fa(e) {
  let t = new Set(mt.peek());
  t.delete(e) || t.add(e), mt.value = t;
}
function Dr(e, t, n) {
  e.shiftKey ? oa(t, ja.peek().filter((o) => o.kind === t).map((o) => o.id), n) : Ge(t, n, e.ctrlKey || e.metaKey ? "toggle" : "only");
}
function Kl(e) {
  let t = { ArrowDown: 1, ArrowUp: -1 }[e.key], n = e.target;
  if (!t || !n.matches(".row-name")) return;
  e.preventDefault();
  let o = [...e.currentTarget.querySelectorAll(".row-name")];
  o[o.indexOf(n) + t]?.focus();
}
var Ol = ["add-spot", "add-point", "add-disc", "add-sphere"];
function Ua() {
  let e = ja.value, t = P.value?.ids[P.value.ids.length - 1], n = e.findIndex((i) => i.kind === P.value?.kind && i.id === t), o = matchMedia("(pointer: coarse)").matches, r = Lt.value === "sheet";
  return l("section", { class: "panel lamps", "aria-label": "Lamps", onKeyDown: Kl, children: [
    l("header", { class: "panel-head", children: [
      l("h2", { children: [
        "Lamps ",
        l("small", { children: B(M.ids.value.length) })
      ] }),
      l("span", { class: "gap" }),
      l("div", { class: "segments", role: "group", "aria-label": "Listing", children: [
        l("button", { "aria-pressed": !r, onClick: () => Lt.value = "faders", children: "Faders" }),
        l("button", { "aria-pressed": r, onClick: () => Lt.value = "sheet", children: "Sheet" })
      ] })
    ] }),
    l("div", { class: "panel-tools", children: [
      l("span", { class: "field filter", children: l(
        "input",
        {
          type: "text",
          "aria-label": "Filter lamps",
          placeholder: "Filter",
          value: bo.value,
          onInput: (i) => bo.value = i.currentTarget.value,
          onKeyDown: (i) => {
            i.key === "Escape" && (bo.value = "", i.stopPropagation());
          }
        }
      ) }),
      r && l("select", { "aria-label": "Order", value: yo.value, onChange: (i) => yo.value = i.currentTarget.value, children: [
        l("option", { value: "group", children: "by group" }),
        l("option", { value: "name", children: "by name" }),
        l("option", { value: "flux", children: "by flux" }),
        l("option", { value: "level", children: "by level" })
      ] }),
      l(qt, { id: "add-menu", label: "Add", title: "Add a lamp", children: [
        Ol.map((i) => l(xr, { id: i }, i)),
        l("button", { class: "item", "aria-disabled": "true", title: "Photometric files come with a later version", children: [
          l("span", { children: "IES or LDT file…" }),
          l("kbd", { children: "later" })
        ] })
      ] })
    ] }),
    r && l(J, { part: "SheetHead" }),
    l(
      Fr,
      {
        label: "Lamps and groups",
        count: e.length,
        height: r ? o ? 44 : 28 : o ? 84 : 54,
        show: n,
        row: (i) => {
          let a = e[i], s = r ? wr("SheetRow") : Da;
          return s && l(s, { row: a, index: i, count: e.length }, `${a.kind}${a.id}`);
        }
      }
    ),
    ue.value.length > 1 && l("p", { class: "several", children: [
      ue.value.length,
      " selected; a fader moves them in proportion",
      P.value?.kind === "lamp" && l("button", { onClick: () => te("group"), children: "Group" }),
      l("button", { onClick: () => te("none"), children: "None" })
    ] }),
    !e.length && M.ids.value.length > 0 && l("p", { class: "quiet empty", children: "No lamp is called so." })
  ] });
}

// src/states.ts
var kn = g(null), Qe = g([]), xn = g(null), qr = g(null), Nr = N(() => Pe.value?.stage ?? "loading"), Wa = g(!1), wn = 0;
T(() => {
  let e = Pe.value?.fps ?? 0;
  Nr.value === "moving" && e > 6 && $t.value < 0.4 * e && $t.value < 5 ? wn || (wn = performance.now()) : wn = 0, Wa.value = wn > 0 && performance.now() - wn > 2e3;
});
var Wt = N(() => {
  switch (U.value) {
    case "entering":
      return "starting";
    case "open":
      break;
    default:
      return U.value;
  }
  return !ee.value || !W.value ? "loading" : it.value.state === "failed" ? "unsaved" : kn.value !== null ? "broken" : xn.value !== null && !F.value.you ? "control-lost" : pe.value === "watch" || !F.value.you ? "watching" : M.ids.value.length === 0 ? "no-lamps" : qi.value ? "all-off" : Wa.value ? "slow" : Nr.value === "loading" ? "first" : Nr.value;
});
Se("event", (e) => {
  switch (e.what) {
    case "reloaded": {
      kn.value = null, Qe.value = e.lost ?? [];
      let t = e.kept ?? 0;
      le(`The scene was read again: ${t} edits kept${Qe.value.length ? `, ${Qe.value.length} no longer find what they changed` : ""}.`);
      break;
    }
    case "broken":
      kn.value = e.why ?? "The scene file cannot be read.";
      break;
    case "taken":
      xn.value = e.by ?? F.peek().name ?? "somebody else";
      break;
    case "loading":
      qr.value = e;
      break;
  }
});
Se("refused", (e) => le(e.why ?? "That could not be done.", "warn"));
T(() => {
  F.value.you && (xn.value = null);
});

// src/probe.ts
var _o = g(null);
function wo(e, t, n) {
  let o = Ot(e, t);
  if (!o) return n(null);
  Me("point", o, (r) => n(r.hit ? r : null));
}
function Ba(e) {
  if (!e) return "";
  let t = [], n = M.get(e.lamp)?.name, o = ye.get(e.thing)?.name, r = xt.get(e.material)?.name;
  if (n && t.push(n), o && o !== n && t.push(o), r && r !== o && t.push(r), e.lux && t.push(`${dt(e.lux[0])} ±${dt(e.lux[1], !1)}`), e.luminance) {
    let i = e.luminance[0] * (Vt.value === "fc" ? 0.2919 : 1);
    t.push(`${Xe(i)} ${Vt.value === "fc" ? "fL" : "cd/m²"}`);
  }
  return t.join(" · ");
}

// src/status.tsx
var Ga = N(() => {
  W.value;
  let e = [];
  for (let t of ae.sent.slice(-24)) {
    if (t.what !== "set" && t.what !== "camera") continue;
    let n = ae.frames.find((o) => o.seq >= t.seq && o.painted);
    n && n.painted > t.at && e.push(n.painted - (t.input || t.at));
  }
  return e.sort((t, n) => t - n), e.length ? e[e.length >> 1] : null;
});
function Dl() {
  let e = Pe.value;
  if (!e) return "starting";
  let t = e.error == null ? "" : ` ±${B((e.error ?? 0) * 100, e.error < 0.0995 ? 1 : 0)} %`;
  switch (e.stage) {
    case "loading":
      return "first look";
    case "moving":
      return `moving${t}`;
    case "refining":
      return `${t.trim() || "refining"}${e.good_in ? `, good in ${B(e.good_in, e.good_in < 3 ? 1 : 0)} s` : ""}`;
    case "good":
      return `good${t}`;
    case "done":
      return `finished${t}`;
  }
}
function za() {
  let e = Pe.value, t = W.value?.head, n = sn.value.filter((r) => r.batches < r.of && !r.held).length, o = e?.stage === "refining" && e.good_in ? Math.max(0.02, 1 / (1 + e.good_in)) : e?.stage === "good" || e?.stage === "done" ? 1 : 0.02;
  return l("footer", { class: "status", "aria-label": "Status", children: [
    l("span", { class: `quality ${e?.stage ?? ""}`, children: [
      l("i", { class: "thin", "aria-hidden": "true", children: l("b", { style: { width: `${o * 100}%` } }) }),
      Dl()
    ] }),
    l("span", { children: [
      B(t?.batches ?? e?.batches ?? 0),
      " batches"
    ] }),
    l("span", { children: U.value === "open" ? `${B($t.value)} fps` : "no line" }),
    Ga.value !== null && l("span", { title: "From the hand to the paint, median", children: [
      B(Ga.value),
      " ms"
    ] }),
    t && l("span", { children: [
      t.width,
      " × ",
      t.height
    ] }),
    l("span", { class: "wide", children: [
      sn.value.length,
      " layers",
      n ? `, ${n} tracing` : ""
    ] }),
    l("span", { class: "probe", "aria-live": "off", children: Ba(_o.value) }),
    l("span", { class: "gap" }),
    l("span", { children: F.value.you ? "editing: you" : `editing: ${F.value.name ?? "somebody else"}` }),
    l("span", { class: "spoken", children: [
      Wn.value ?? "",
      " ",
      Wt.value
    ] })
  ] });
}

// src/pointer.ts
var Fl = 4, Xa = 35e-4, Nl = 0.15;
function ql(e, t, n) {
  return e === "maya" && n.alt ? ["orbit", "pan", "dolly"][t] ?? "none" : e === "blender" && t === 1 ? n.shift ? "pan" : n.ctrl ? "dolly" : "orbit" : t === 1 ? n.shift ? "pan" : "orbit" : t === 2 ? "look" : t === 0 ? n.alt ? "orbit" : n.space ? "pan" : n.shift || n.ctrl ? "none" : "look" : "none";
}
function Ya(e, t) {
  let n = /* @__PURE__ */ new Map(), o = Dt(), r = 3, i = !1, a = 0, s = 0, p = 0, c = null, u = (h) => {
    let v = e.getBoundingClientRect();
    return [h.clientX - v.left, h.clientY - v.top];
  }, d = (h, v, $) => {
    let L = Ot(h, v);
    L && Me("point", L, (V) => {
      let A = V;
      A.hit && $?.(A);
    });
  }, m = (h) => {
    let v = ft();
    return v ? Math.max(0.2, q(O(h, v.eye), v.forward)) : r;
  };
  function f(h) {
    if (h.target.closest("[data-handle]")) return;
    e.focus({ preventScroll: !0 });
    let [v, $] = u(h), L = h.pointerType === "touch", V = { alt: h.altKey, shift: h.shiftKey, ctrl: h.ctrlKey || h.metaKey, space: i }, A = L ? "look" : ql(Xn.peek(), h.button, V);
    A === "look" && oe()?.height && (A = "pan"), G.peek() === "marquee" && h.button === 0 && (A = "none"), n.set(h.pointerId, {
      id: h.pointerId,
      button: h.button,
      x: v,
      y: $,
      startX: v,
      startY: $,
      moved: !1,
      motion: A,
      touch: L,
      shift: h.shiftKey,
      ctrl: V.ctrl
    }), e.setPointerCapture(h.pointerId), clearTimeout(a), t.unhover(), (A === "orbit" || A === "pan" || A === "dolly") && (o = Dt(), r = m(o), d(v, $, (R) => {
      o = R.point, r = m(R.point);
    })), clearTimeout(s), L && n.size === 1 && (s = window.setTimeout(() => {
      let R = n.get(h.pointerId);
      R && !R.moved && n.size === 1 && (R.moved = !0, R.motion = "none", t.menu(R.x, R.y));
    }, 550)), n.size === 2 && (c = b()), h.button === 1 && h.preventDefault();
  }
  function b() {
    let [h, v] = [...n.values()];
    return { gap: Math.hypot(h.x - v.x, h.y - v.y), x: (h.x + v.x) / 2, y: (h.y + v.y) / 2 };
  }
  function y(h) {
    let v = n.get(h.pointerId), [$, L] = u(h);
    if (!v) {
      if (h.pointerType === "touch" || h.buttons) return;
      t.unhover(), clearTimeout(a), a = window.setTimeout(() => t.hover($, L), 150);
      return;
    }
    let [V, A] = [$ - v.x, L - v.y];
    if (!(!v.moved && Math.hypot($ - v.startX, L - v.startY) < Fl)) {
      if (v.moved = !0, v.x = $, v.y = L, n.size === 2 && c) {
        let R = b();
        Ft(R.x - c.x, R.y - c.y, r), R.gap > 8 && c.gap > 8 && k(R.x, R.y, c.gap / R.gap, !1), c = R;
        return;
      }
      if (G.peek() === "marquee" && v.button === 0) {
        t.marquee([v.startX, v.startY], [$, L], !1);
        return;
      }
      switch (v.motion) {
        case "look": {
          let R = v.touch ? 1 : -1;
          no(R * V * Xa, R * A * Xa);
          break;
        }
        case "orbit":
          oo(o, -V * 6e-3, -A * 6e-3);
          break;
        case "pan":
          Ft(V, A, r);
          break;
        case "dolly":
          k(v.startX, v.startY, Math.exp(A * 6e-3), !1);
          break;
        case "none":
          break;
      }
    }
  }
  function w(h) {
    let v = n.get(h.pointerId);
    if (n.delete(h.pointerId), clearTimeout(s), n.size < 2 && (c = null), !(!v || h.type === "pointercancel")) {
      if (v.moved) {
        G.peek() === "marquee" && t.marquee([v.startX, v.startY], [v.x, v.y], !0);
        return;
      }
      if (v.touch) {
        let $ = performance.now(), L = $ - p < 320;
        if (p = $, L) return t.double();
        if (_e.peek()) return;
      }
      if (v.button === 2) t.menu(v.x, v.y);
      else if (v.button === 0) {
        let $ = v.shift ? "add" : v.ctrl ? "toggle" : "only";
        t.click(v.x, v.y, $);
      }
    }
  }
  let x = null;
  function k(h, v, $, L) {
    let V = oe(), A = ft();
    if (!V || !A) return;
    if (V.height) return Q(Fn(V, A, h, v, $));
    let R = performance.now();
    if (!x || R - x.time > 500 || Math.hypot(h - x.x, v - x.y) > 6) {
      x = { x: h, y: v, time: R, point: null };
      let vt = x;
      d(h, v, (Gr) => {
        vt.point = Gr.point, r = m(Gr.point);
      });
    }
    x.time = R;
    let [ss, ls] = [h - A.width / 2, A.height / 2 - v], us = Math.min(r, Ke(V.eye, Dt()) + 1), ko = (vt) => V.eye[vt] + (A.forward[vt] + A.side[vt] * ss * A.pixel + A.up[vt] * ls * A.pixel) * us, Br = x.point ?? [ko(0), ko(1), ko(2)];
    Q(Dn(V, Br, $, Nl, L)), L && Ke(V.eye, Br) < 0.5 && (x = null);
  }
  function _(h) {
    if (h.target.closest("[data-scroll]")) return;
    h.preventDefault();
    let v = h.deltaMode === 1 ? 18 : h.deltaMode === 2 ? 400 : 1, [$, L] = [h.deltaX * v, h.deltaY * v], [V, A] = u(h);
    if (Xn.peek() === "trackpad" && !h.ctrlKey) return Ft(-$, -L, r);
    let R = (h.ctrlKey ? 6 : 1) * (Math.abs(L) > Math.abs($) ? L : $);
    k(V, A, Math.exp(Math.max(-300, Math.min(300, R)) * 16e-4), h.shiftKey && !h.ctrlKey);
  }
  let C = (h) => h.preventDefault(), Ce = () => {
    clearTimeout(a), t.unhover();
  }, Je = (h) => {
    !h.target.closest("[data-handle]") && G.peek() === null && t.double();
  }, fe = (h) => {
    h.code === "Space" && (i = h.type === "keydown");
  }, ve = new ResizeObserver(() => {
    let h = e.getBoundingClientRect();
    we.value = [Math.max(16, Math.round(h.width)), Math.max(16, Math.round(h.height))];
  });
  return ve.observe(e), e.addEventListener("pointerdown", f), e.addEventListener("pointermove", y), e.addEventListener("pointerup", w), e.addEventListener("pointercancel", w), e.addEventListener("pointerleave", Ce), e.addEventListener("wheel", _, { passive: !1 }), e.addEventListener("contextmenu", C), e.addEventListener("dblclick", Je), addEventListener("keydown", fe), addEventListener("keyup", fe), () => {
    ve.disconnect(), removeEventListener("keydown", fe), removeEventListener("keyup", fe);
  };
}

// src/overlay.ts
var jl = "http://www.w3.org/2000/svg";
function ke(e, t = {}, n) {
  let o = document.createElementNS(jl, e);
  for (let [r, i] of Object.entries(t)) o.setAttribute(r, String(i));
  return n?.append(o), o;
}
var Ur = class {
  view;
  fit;
  constructor(t) {
    this.view = t, this.fit = hn(t.width, t.height);
  }
  at(t) {
    let [n, o, r] = tn(this.view, t);
    return r < 0.02 && !this.view.parallel ? null : [this.fit.x + n * this.fit.scale, this.fit.y + o * this.fit.scale];
  }
  /** A line of the scene as a path, as much of it as lies before the eye. */
  line(t, n) {
    let [, , o] = tn(this.view, t), [, , r] = tn(this.view, n), i = 0.05, [a, s] = [t, n];
    if (!this.view.parallel) {
      if (o < i && r < i) return "";
      let u = (i - o) / (r - o), d = I(S(t, 1 - u), S(n, u));
      o < i && (a = d), r < i && (s = d);
    }
    let [p, c] = [this.at(a), this.at(s)];
    return !p || !c ? "" : `M${p[0].toFixed(1)} ${p[1].toFixed(1)}L${c[0].toFixed(1)} ${c[1].toFixed(1)}`;
  }
};
function Wr() {
  let e = W.value;
  return we.value, e ? new Ur(wt(e.camera, e.head.width, e.head.height)) : null;
}
function Qa() {
  let e = re(Wr);
  return e ? M.all().flatMap(([t, n]) => {
    let o = Ja(n), r = o && e.at(o);
    return r ? [{ id: t, at: r }] : [];
  }) : null;
}
var Ja = hr, Ul = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
function jr(e, t) {
  let n = _t(t);
  return Ul.map(([o, r]) => e.line(n[o], n[r])).join("");
}
var Wl = 150, Sn = class {
  constructor(t, n, o) {
    this.parent = t;
    this.kind = n;
    this.shape = o;
  }
  parent;
  kind;
  shape;
  marks = /* @__PURE__ */ new Map();
  draw(t) {
    let n = /* @__PURE__ */ new Set();
    for (let { id: o, at: r, label: i, state: a } of t) {
      n.add(o);
      let s = this.marks.get(o);
      if (!s) {
        let p = ke("g", { "data-kind": this.kind, "data-id": o }, this.parent);
        this.shape(p);
        let c = ke("text", { x: 10, y: 4 }, p);
        s = { group: p, label: c }, this.marks.set(o, s);
      }
      if (!r) {
        s.group.setAttribute("display", "none");
        continue;
      }
      s.group.removeAttribute("display"), s.group.setAttribute("transform", `translate(${r[0].toFixed(1)} ${r[1].toFixed(1)})`), s.group.setAttribute("class", `mark ${this.kind} ${a}`), s.label.textContent !== i && (s.label.textContent = i);
    }
    for (let [o, r] of this.marks)
      n.has(o) || (r.group.remove(), this.marks.delete(o));
  }
};
function Za(e) {
  let t = ke("path", { class: "aims" }, e), n = ke("path", { class: "boxes" }, e), o = ke("path", { class: "boxes hover" }, e), r = ke("path", { class: "grid-lines" }, e), i = new Sn(ke("g", {}, e), "lamp", (u) => ke("circle", { r: 4.5 }, u)), a = new Sn(ke("g", {}, e), "grid", () => {
  }), s = new Sn(ke("g", {}, e), "meter", (u) => {
    ke("circle", { r: 5.5 }, u), ke("path", { d: "M-9 0H9M0 -9V9" }, u);
  }), p = T(() => {
    let u = Wr();
    if (!u) return;
    let d = P.value, m = me.value, f = "", b = "", y = M.ids.value.length <= Wl, w = M.all().map(([k, _]) => {
      let C = d?.kind === "lamp" ? d.ids.includes(k) : d?.kind === "group" && d.ids.includes(_.group ?? -1), Ce = m?.kind === "lamp" ? m.id === k : m?.kind === "group" && m.id === _.group, Je = Ja(_), fe = _.place?.position;
      if (C && _.box && (b += jr(u, _.box)), fe && _.place?.direction && (C || Ce)) {
        let v = _.place.aim ?? I(fe, _.place.direction);
        f += u.line(fe, v);
      }
      let ve = C || Ce || y && tr.value && (_.own || _.place?.position), h = `${C ? "selected" : ""} ${Ce ? "under" : ""} ${st(_) ? "" : "off"}`;
      return { id: k, at: Je && ve ? u.at(Je) : null, label: C || Ce ? _.name : "", state: h };
    });
    if (i.draw(w), t.setAttribute("d", f), d?.kind === "thing")
      for (let k of d.ids) {
        let _ = ye.get(k)?.box;
        _ && (b += jr(u, _));
      }
    n.setAttribute("d", b);
    let x = m?.kind === "lamp" ? M.get(m.id)?.box : m?.kind === "thing" ? ye.get(m.id)?.box : null;
    o.setAttribute("d", x ? jr(u, x) : "");
  }), c = T(() => {
    let u = Wr();
    if (!u) return;
    let d = P.value, m = (b, y) => d?.kind === b && d.ids.includes(y) ? "selected" : "";
    s.draw(Ct.all().map(([b, y]) => ({
      id: b,
      at: u.at(y.point),
      label: y.lux ? dt(y.lux[0]) : "…",
      state: m("meter", b)
    })));
    let f = "";
    a.draw(qn.all().map(([b, y]) => {
      f += Bl(u, y);
      let w = y.mean == null ? "…" : `${y.name} ${dt(y.mean)}`;
      return { id: b, at: u.at(y.corner), label: w, state: m("grid", b) };
    })), r.setAttribute("d", f);
  });
  return () => {
    p(), c(), e.replaceChildren();
  };
}
function es({ corner: e, u: t, v: n, columns: o, rows: r, border: i = 0 }, a, s) {
  let p = (c, u, d) => {
    let m = be(c) > 2 * i ? i / be(c) : 0;
    return S(c, m + (1 - 2 * m) * (u + 0.5) / d);
  };
  return I(e, I(p(t, a, o), p(n, s, r)));
}
function Bl(e, t) {
  let n = (r, i) => I(t.corner, I(S(t.u, r), S(t.v, i))), o = e.line(n(0, 0), n(1, 0)) + e.line(n(1, 0), n(1, 1)) + e.line(n(1, 1), n(0, 1)) + e.line(n(0, 1), n(0, 0));
  for (let r = 0; r < t.rows; r++)
    for (let i = 0; i < t.columns; i++) {
      let a = e.at(es(t, i, r));
      a && (o += `M${(a[0] - 2).toFixed(1)} ${a[1].toFixed(1)}h4m-2 -2v4`);
    }
  return o;
}

// src/banner.tsx
function ce({ tone: e, children: t }) {
  return l("div", { class: `banner ${e}`, role: e === "warn" ? "alert" : "status", children: t });
}
var ts = () => `lampyris view ${ee.peek()?.file ?? "SCENE"} --port ${location.port || 80}`;
function Gl() {
  let e = M.all().filter(([, n]) => !n.on || n.level === 0 || n.parked), t = D.all().filter(([, n]) => !n.on || n.level === 0);
  Ve("All lamps on", {
    lamps: Object.fromEntries(e.map(([n, o]) => [n, { on: !0, parked: !1, ...o.level === 0 ? { level: 1 } : {} }])),
    groups: Object.fromEntries(t.map(([n, o]) => [n, { on: !0, ...o.level === 0 ? { level: 1 } : {} }]))
  });
}
function zl() {
  switch (Wt.value) {
    case "starting":
      return l(ce, { tone: "calm", children: "Entering…" });
    case "loading": {
      let e = qr.value;
      return l(ce, { tone: "calm", children: [
        "Reading ",
        e?.file ?? ee.value?.file ?? "the scene",
        "…",
        e?.bytes ? ` ${B(e.bytes / 1e6, 1)} MB` : "",
        e?.progress != null && l("progress", { value: e.progress, max: 1, "aria-label": "Reading" })
      ] });
    }
    case "lost":
      return l(ce, { tone: "warn", children: [
        "Connection lost, trying again",
        cn.value ? ` (${cn.value} s)` : "…",
        ". Until then nothing can be changed."
      ] });
    case "ended":
      return l(ce, { tone: "warn", children: [
        l("span", { children: [
          "The program has ended. Start it again with ",
          l("code", { children: ts() }),
          ": this page comes back by itself."
        ] }),
        l("button", { onClick: () => {
          yr(ts());
        }, children: "Copy" })
      ] });
    case "denied":
      return l(ce, { tone: "warn", children: "This link is not valid (any more). Open the one that the program has printed, or ask for a new one." });
    case "renewed":
      return l(ce, { tone: "warn", children: [
        "New version. ",
        l("button", { onClick: () => location.reload(), children: "Reload" })
      ] });
    case "unsaved":
      return l(ce, { tone: "warn", children: [
        "Edits are not being saved: ",
        it.value.why ?? "unknown reason",
        ".",
        l("button", { onClick: () => pt.value = "save", children: "Save elsewhere" })
      ] });
    case "broken":
      return l(ce, { tone: "warn", children: [
        kn.value,
        " Still showing what was read before."
      ] });
    case "control-lost":
      return l(ce, { tone: "warn", children: [
        l("span", { children: [
          "Control moved to ",
          l("em", { children: xn.value }),
          "."
        ] }),
        " ",
        l("button", { onClick: () => K({ do: "edit", what: "take" }), children: "Take it back" })
      ] });
    case "watching":
      return l(ce, { tone: "calm", children: [
        l("span", { children: [
          "You are watching",
          F.value.name ? l(X, { children: [
            "; ",
            l("em", { children: F.value.name }),
            " edits"
          ] }) : "",
          "."
        ] }),
        l("button", { onClick: () => K({ do: "edit", what: "take" }), children: "Ask for control" })
      ] });
    case "no-lamps":
      return l(ce, { tone: "calm", children: [
        "This scene has no light. Add:",
        l(
          "button",
          {
            onClick: () => {
              dr.value = "disc", mr("add");
            },
            children: "ceiling lamp"
          }
        ),
        l("button", { disabled: !0, title: "Photometric files come with a later version", children: "IES file" })
      ] });
    case "all-off":
      return l(ce, { tone: "warn", children: [
        "All lamps are off.",
        rt.value.undo && l("button", { onClick: () => te("undo"), children: "Undo" }),
        l("button", { onClick: Gl, children: "Turn on" })
      ] });
    case "slow":
      return l(ce, { tone: "calm", children: [
        "Slow connection.",
        l("button", { "aria-pressed": We.value, onClick: () => We.value = !0, children: "Sharper" }),
        l("button", { "aria-pressed": !We.value, onClick: () => We.value = !1, children: "Faster" })
      ] });
    default:
      return null;
  }
}
function ns() {
  let e = xe.value;
  return l("div", { class: "banners", "data-scroll": !0, children: [
    zl(),
    Qe.value.length > 0 && l(ce, { tone: "calm", children: [
      l("details", { children: [
        l("summary", { children: [
          Qe.value.length,
          " edits no longer find what they changed"
        ] }),
        l("ul", { children: Qe.value.map((t) => l("li", { children: t }, t)) })
      ] }),
      l("button", { onClick: () => Qe.value = [], children: "Good" })
    ] }),
    e.length > 0 && l("div", { class: "banner badge", role: "status", children: [
      "Solo: ",
      e.length === 1 ? M.get(e[0])?.name ?? "one lamp" : `${e.length} lamps`,
      l("button", { onClick: Mr, children: "End solo" })
    ] }),
    l("div", { class: "notes", role: "status", "aria-live": "polite", children: ct.value.map((t) => l("div", { class: `banner ${t.tone === "warn" ? "warn" : "calm"}`, children: [
      t.text,
      l("button", { class: "icon", "aria-label": "Close", onClick: () => or(t.id), children: l(z, { name: "close" }) })
    ] }, t.id)) })
  ] });
}

// src/view.tsx
var rs = g(null);
function Xl(e, t) {
  let n = Qa();
  if (!n) return [];
  let [o, r] = [Math.min(e[0], t[0]), Math.max(e[0], t[0])], [i, a] = [Math.min(e[1], t[1]), Math.max(e[1], t[1])];
  return n.filter(({ at: s }) => s[0] >= o && s[0] <= r && s[1] >= i && s[1] <= a).map(({ id: s }) => s);
}
var Yl = {
  click(e, t, n) {
    let o = os(e, t);
    if (G.peek() === null && o) return Ge(o.kind, o.id, n);
    wo(e, t, (r) => {
      if (r && (to.value = { point: r.point, normal: r.normal }), G.peek() !== null) return fa(r);
      ia(r, n), P.peek() && (Ae.value = "inspector");
    });
  },
  menu(e, t) {
    wo(e, t, (n) => {
      n && fo(e, t, n);
    });
  },
  double() {
    fr();
  },
  hover(e, t) {
    let n = os(e, t);
    n?.kind === "lamp" && (me.value = { kind: "lamp", id: n.id }), wo(e, t, (o) => {
      _o.value = o, o && (to.value = { point: o.point, normal: o.normal }), o?.lamp != null && (me.value = { kind: "lamp", id: o.lamp });
    });
  },
  unhover() {
    me.peek() && (me.value = null);
  },
  marquee(e, t, n) {
    if (rs.value = n ? null : { from: e, to: t }, !n) return;
    let o = Xl(e, t);
    P.value = o.length ? { kind: "lamp", ids: o } : null, G.value = null;
  }
};
function os(e, t) {
  let n = document.getElementById("overlay"), o = null, r = 11;
  for (let i of n?.querySelectorAll(".mark:not([display])") ?? []) {
    let a = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(i.getAttribute("transform") ?? "");
    if (!a) continue;
    let s = Math.hypot(Number(a[1]) - e, Number(a[2]) - t);
    s < r && (r = s, o = { kind: i.dataset.kind, id: Number(i.dataset.id) });
  }
  return o;
}
var Ql = {
  aim: "Click what shall be lit. Esc to leave.",
  place: "Click the surface on which the lamp shall be. Esc to leave.",
  meter: "Click where the meter shall lie. Esc to leave.",
  grid: "Click two opposite corners of the area. Esc to leave.",
  add: "Click where the lamp shall hang. Esc to leave.",
  marquee: "Drag around the lamps to select. Esc to leave."
};
function is() {
  let e = ne(null), t = ne(null), n = ne(null);
  return Ee(() => {
    Xo(t.current);
    let o = Za(n.current), r = Ya(e.current, Yl);
    return () => {
      Xo(null), o(), r();
    };
  }, []), Ci(() => {
    let o = W.value;
    t.current?.setAttribute("data-kind", o?.head.kind ?? "none");
  }), l("main", { class: "view", "aria-label": "View", children: [
    l(
      "div",
      {
        class: G.value ? "stage tooled" : "stage",
        id: "view",
        ref: e,
        tabIndex: 0,
        role: "application",
        "aria-label": `View of ${ee.value?.name ?? "the scene"}${Kt.value ? `, ${Kt.value}` : ""}`,
        "aria-describedby": "view-keys",
        "data-tool": G.value ?? "",
        children: [
          l("canvas", { ref: t, width: 640, height: 480, "aria-hidden": "true" }),
          l("svg", { id: "overlay", ref: n, "aria-hidden": "true" }),
          l(J, { part: "Gizmo" }),
          l(J, { part: "Compare" }),
          l(Jl, {})
        ]
      }
    ),
    l("p", { id: "view-keys", class: "spoken", children: "Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection, Escape leaves the view." }),
    G.value && l("p", { class: "hint", role: "status", children: Ql[G.value] }),
    l(ns, {}),
    l(J, { part: "TypedHint" }),
    l(J, { part: "Legend" }),
    l(J, { part: "CutBar" }),
    l(J, { part: "ViewStrip" }),
    l(J, { part: "WalkPad" }),
    l(J, { part: "What" })
  ] });
}
function Jl() {
  let e = rs.value;
  if (!e) return null;
  let { from: t, to: n } = e;
  return l("svg", { class: "rubber", "aria-hidden": "true", children: l(
    "rect",
    {
      x: Math.min(t[0], n[0]),
      y: Math.min(t[1], n[1]),
      width: Math.abs(n[0] - t[0]),
      height: Math.abs(n[1] - t[1])
    }
  ) });
}

// src/main.tsx
function Zl() {
  return l(X, { children: [
    l(wa, {}),
    l(Ua, {}),
    l(is, {}),
    l("section", { class: "panel inspector", "aria-label": "Inspector", children: l(J, { part: "Inspector" }) }),
    l("section", { class: "strip", "aria-label": "Looks and meters", children: l(J, { part: "Strip" }) }),
    l(za, {}),
    l(J, { part: "Sheets" })
  ] });
}
var ht = document.getElementById("desk");
ht.replaceChildren();
ai(l(Zl, {}), ht);
T(() => {
  ht.dataset.state = Wt.value, ht.dataset.line = U.value, ht.dataset.pen = pe.value === "edit" && F.value.you && !_e.value ? "yes" : "no";
});
T(() => {
  ht.dataset.panels = Zo.value ? "yes" : "no", ht.dataset.drawer = Ae.value ?? "none";
});
T(() => {
  document.documentElement.dataset.theme = Yo.value, document.documentElement.style.setProperty("--house", String(Qo.value));
});
T(() => {
  ee.value && (document.title = `${ee.value.name} – Lampyris`);
});
var as = 0;
T(() => {
  let [e, t] = we.value, n = We.value ? Math.min(devicePixelRatio, 2) : 1;
  U.value !== "open" || pe.value === "watch" || !F.value.you || (clearTimeout(as), as = window.setTimeout(() => K({ do: "size", width: Math.round(e * n), height: Math.round(t * n) }), 60));
});
va();
Aa();
Gi();
export {
  _n as Fade,
  gn as Field,
  X as Fragment,
  Be as Gesture,
  z as Icon,
  xr as Item,
  As as PRESETS,
  Kr as Range,
  Fr as Virtual,
  ot as across,
  te as act,
  I as add,
  dr as adding,
  gl as allActions,
  Me as ask,
  pa as asked,
  nl as back,
  pn as before,
  he as camera,
  Vt as candles,
  ue as chosenLamps,
  Mr as clearSolo,
  po as closeWhat,
  Oa as colorText,
  ao as command,
  dn as compareHeld,
  de as comparing,
  Ii as compass,
  N as computed,
  yr as copyText,
  Or as cost,
  ge as cross,
  Hr as css,
  ll as cut,
  Zn as deselect,
  B as digits,
  at as display,
  Ke as distance,
  q as dot,
  fl as each,
  Ve as edit,
  F as editor,
  T as effect,
  so as exposeBy,
  nr as fade,
  dl as falseColor,
  Rs as filterOf,
  We as fine,
  hn as fitted,
  vn as format,
  ol as forth,
  fr as frameSelection,
  ro as free,
  Rl as fromHex,
  Q as go,
  pr as goHome,
  sl as goInside,
  al as goPreset,
  es as gridPoint,
  qn as grids,
  D as groups,
  Zs as handles,
  Xn as hands,
  Se as hear,
  oe as here,
  Ha as hex,
  co as highlight,
  rt as history,
  Qo as houseLights,
  me as hovered,
  l as jsx,
  l as jsxs,
  Cl as keysFirst,
  tr as lampMarks,
  M as lamps,
  sn as layers,
  be as length,
  Lt as listing,
  _e as lookOnly,
  Mt as looks,
  Uo as lumensOf,
  dt as luxText,
  Ws as maintenance,
  xt as materials,
  Ct as meters,
  qe as middle,
  Hl as mired,
  ra as nameOf,
  Z as normal,
  cl as onTool,
  st as output,
  $l as padWalk,
  Zo as panels,
  Qn as penless,
  Re as percent,
  Dr as pickRow,
  wt as pinhole,
  hr as positionOf,
  tn as project,
  Is as ray,
  vl as register,
  pe as role,
  le as say,
  S as scale,
  ee as scene,
  Ge as select,
  P as selection,
  K as send,
  ul as setCut,
  pt as sheet,
  At as show,
  W as shown,
  g as signal,
  er as singleKeys,
  wl as soloSelection,
  to as spot,
  mr as startTool,
  Pe as status,
  Xs as step,
  el as stepSelection,
  hl as storeLook,
  ml as storeView,
  rr as stroke,
  go as strokeLevel,
  O as sub,
  Rr as switchOn,
  Yo as theme,
  ye as things,
  Xe as three,
  eo as titleOf,
  Lr as toLevel,
  $r as toTravel,
  br as toggleFalse,
  Js as toggleWipe,
  G as tool,
  Yn as travel,
  en as turn,
  Ar as typeGroupLevel,
  Ir as typeLevel,
  re as untracked,
  Ie as up,
  Ee as useEffect,
  ys as useLayoutEffect,
  ne as useRef,
  Kt as viewName,
  we as viewSize,
  St as views,
  La as walkNames,
  Jo as walking,
  gr as wantLevel,
  Ye as what,
  Jn as whyNot,
  _r as whyNotTo,
  Ys as wipeAt,
  Bs as workPlane
};
