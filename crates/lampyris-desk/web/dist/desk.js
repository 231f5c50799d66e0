// node_modules/preact/dist/preact.mjs
var M, Br, ko, qe, yo, En, zr, Mn, Gr, xo, wo, es, zt = /* @__PURE__ */ Symbol.for("pv"), Tn = {}, Pn = [], ts = /^m(i|n|o|s|text|space)$/, So = Array.isArray, Mo = Pn.slice, tt = Object.assign;
function et(e) {
  e && e.parentNode && e.remove();
}
function Xr(e, t, n) {
  var o, r, i, a = {}, s = arguments.length;
  for (i in t) i == "key" ? o = t[i] : i == "ref" && typeof e != "function" ? r = t[i] : a[i] = t[i];
  return s > 2 && (a.children = s > 3 ? Mo.call(arguments, 2) : n), Bt(e, a, o, r, null);
}
function Bt(e, t, n, o, r) {
  var i = { type: e, props: t, key: n, ref: o, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: zt, __v: r || ++Br, __i: -1, __u: 0 };
  return !r && M.vnode && M.vnode(i), i;
}
function X(e) {
  return e.children;
}
function gt(e, t) {
  this.props = e, this.context = t, this.__g = 0;
}
function je(e, t) {
  if (t == null) return e.__ && je(e.__, e.__i + 1);
  for (var n; t < e.__k.length; t++) if ((n = e.__k[t]) && n.__e) return n.__e;
  return typeof e.type != "function" || e.props.__P ? null : je(e);
}
function ns(e) {
  var t, n = e.__v, o = n.__e, r = [], i = [], a = e.__P;
  a && ((t = tt({ constructor: zt }, n)).__v = n.__v + 1, M.vnode && M.vnode(t), Co(a, t, n, e.__n, a.namespaceURI, 32 & n.__u ? [o] : null, r, o || je(n), 32 & n.__u, i), t.__v = n.__v, t.__.__k[t.__i] = t, ti(r, t, i), n.__ = n.__e = null, t.__e != o && Yr(t));
}
function Yr(e) {
  if ((e = e.__) && e.__c && !e.props.__P) return e.__e = null, e.__k.some(function(t) {
    return t && (e.__e = t.__e);
  }), Yr(e);
}
function Ur(e) {
  (8 & e.__g || (e.__g |= 8, qe.push(e), En++)) && yo == M.debounceRendering || ((yo = M.debounceRendering) || queueMicrotask)(Qr);
}
function Qr() {
  try {
    for (var e, t = 1; qe.length; ) qe.length > t && qe.sort(zr), e = qe.shift(), t = qe.length, 8 & e.__g && ns(e);
  } finally {
    (En = qe.length) && (yo || queueMicrotask)(Qr);
  }
}
function Jr(e, t, n, o, r, i, a, s, d, c, u) {
  var p, m, f, y, w, x, _ = o.__k || Pn, b = t.length;
  for (d = os(n, t, _, d, b), p = 0; p < b; p++) (f = n.__k[p]) != null && (m = ~f.__i && _[f.__i] || Tn, f.__i = p, x = Co(e, f, m, r, i, a, s, d, c, u), y = f.__e, (m.ref != f.ref || 8 & m.__u) && (m.ref && Eo(m.ref, null, f, m), f.ref && u.push(f.ref, f.__c || y, f)), w = w || y, 4 & f.__u ? (d = Zr(f, d, e, !m.__v), m.__e && (m.__e = null)) : typeof f.type == "function" && x !== void 0 ? d = x : y && (d = y.nextSibling), f.__u &= -21);
  return n.__e = w, d;
}
function os(e, t, n, o, r) {
  var i, a, s, d, c, u, p, m, f, y = n.length, w = y, x = 0, _ = 0, b = e.__k = Array(r);
  for (i = 0; i < r; i++) (a = t[i]) != null && typeof a != "boolean" && typeof a != "function" ? (typeof a != "object" || a.constructor === String ? a = b[i] = Bt(null, a) : So(a) ? a = b[i] = Bt(X, { children: a }) : a.constructor === zt && a.__b ? a = b[i] = Bt(a.type, a.props, a.key, a.ref, a.__v) : b[i] = a, d = i + x, a.__ = e, a.__b = e.__b + 1, s = null, ~(c = a.__i = rs(a, n, d, w)) && (w--, (s = n[c]) && (s.__u |= 2)), s && s.__v ? (a.__u |= 16, c == d - 1 ? x-- : c == d + 1 ? x++ : c != d && (c > d ? x-- : x++, _ = 1)) : (~c || (r > y ? x-- : r < y && x++), typeof a.type != "function" && (a.__u |= 4))) : b[i] = null;
  if (_) {
    for (u = [], p = [], i = 0; i < r; i++) if ((a = b[i]) && 16 & a.__u) {
      for (x = 0, m = u.length; x < m; ) u[f = x + m >> 1] < a.__i ? x = f + 1 : m = f;
      u[x] = a.__i, p[i] = x + 1;
    }
    for (x = u.length; i--; ) p[i] && (p[i] == x ? x-- : b[i].__u |= 4);
  }
  if (w) for (i = 0; i < y; i++) !(s = n[i]) || 2 & s.__u || (s.__e == o && (o = je(s)), To(s, s));
  return o;
}
function Zr(e, t, n, o) {
  var r, i, a, s;
  if (typeof e.type == "function") {
    if (e.props.__P) return t;
    if (r = e.__k) for (i = 0; i < r.length; i++) r[i] && (r[i].__ = e, t = Zr(r[i], t, n, !1));
    return t;
  }
  for (t && !t.parentNode && (t = je(e)) && !t.parentNode && (t = null), a = e.__e, s = t; s && s.nodeType == 8; ) s = s.nextSibling;
  for (a != s && (!o && n.moveBefore && a.parentNode ? n.moveBefore(a, t) : n.insertBefore(a, t || null)), t = a; (t = t && t.nextSibling) && t.nodeType == 8 && !t.data.startsWith("$s"); ) ;
  return t;
}
function rs(e, t, n, o) {
  var r, i = e.key, a = e.type, s = t[n], d = s && !(2 & s.__u);
  if (s === null && i == null || d && i == s.key && a == s.type) return n;
  if (o > (d ? 1 : 0)) {
    for (r = n - 1; r >= 0; r--) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
    for (r = n + 1; r < t.length; r++) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
  }
  return -1;
}
function Wr(e, t, n) {
  n == null && (n = ""), t[0] == "-" ? e.setProperty(t, n) : e[t] = n;
}
function Sn(e, t, n, o, r) {
  var i, a;
  if (t == "style") if (typeof n == "string") e.style.cssText = n;
  else {
    if (typeof o == "string" && (e.style.cssText = o = ""), o) for (t in o) n && t in n || Wr(e.style, t);
    if (n) for (t in n) o && n[t] == o[t] || Wr(e.style, t, n[t]);
  }
  else if (t[0] == "o" && t[1] == "n") typeof n != "function" && (n = null), typeof o != "function" && (o = null), (e.__e || (e.__e = {}))[t] = n, n && o || (a = wo[t] || (wo[t] = is(t)), (e.__a || (e.__a = {}))[t] = xo, i = t != (t = t.replace(Gr, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), n ? e.addEventListener(t, a, i) : e.removeEventListener(t, a, i));
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
function is(e) {
  return function(t) {
    var n = this.__e;
    if (n) {
      if (n = n[e], t[Mn] == null) t[Mn] = xo++;
      else if (t[Mn] < this.__a[e]) return;
      return n(M.event ? M.event(t) : t);
    }
  };
}
function Co(e, t, n, o, r, i, a, s, d, c) {
  var u, p, m, f, y, w, x, _, b, A, L, Fe, Ne, ye, me, h, v, T, P = t.type;
  if (t.constructor !== zt) return null;
  128 & n.__u && (d = 32 & n.__u, u = n.__c.__z) && (t.__u |= d, p = i = [], u.nodeType == 8 ? s = Cn(u, i) : i.push(u), s = i[0] || s), (u = M.__b) && u(t);
  e: if (typeof P == "function") {
    m = a.length;
    try {
      if (_ = t.props, b = (u = P.prototype) && u.render, A = (u = P.contextType) && o[u.__c], L = u ? A ? A.props.value : u.__ : o, (f = n.__c) ? (t.__c = f, 2 & f.__g && (f.__g |= 1)) : (b ? t.__c = f = new P(_, L) : (t.__c = f = new gt(_, L), f.constructor = P, f.render = ss), A && A.sub(f), f.state || (f.state = {}), f.__n = o, f.__g |= 8, f.__h = [], f.__k = []), b && (f.__s || (f.__s = f.state), P.getDerivedStateFromProps && (f.__s == f.state && (f.__s = tt({}, f.__s)), tt(f.__s, P.getDerivedStateFromProps(_, f.__s)))), y = f.props, w = f.state, f.__v = t, n.__c) {
        if (_ !== y && b && !P.getDerivedStateFromProps && f.componentWillReceiveProps && f.componentWillReceiveProps(_, L), t.__v == n.__v && !(8 & f.__g) || !(4 & f.__g) && f.shouldComponentUpdate && f.shouldComponentUpdate(_, f.__s, L) === !1) {
          t.__v != n.__v && (f.props = _, f.state = f.__s, f.__g &= -9), t.__e = n.__e, t.__k = n.__k, t.__k.some(function($) {
            $ && ($.__ = t);
          }), Pn.push.apply(f.__h, f.__k), f.__k = [], f.__h.length && a.push(f), s = je(n);
          break e;
        }
        f.componentWillUpdate && f.componentWillUpdate(_, f.__s, L), b && f.componentDidUpdate && f.__h.push(function() {
          f.componentDidUpdate(y, w, x);
        });
      } else b && !P.getDerivedStateFromProps && f.componentWillMount && f.componentWillMount(), b && f.componentDidMount && f.__h.push(f.componentDidMount);
      f.context = L, f.props = _, f.__P = e, f.__g &= -5, Fe = M.__r, Ne = b ? 25 : 0;
      do
        f.__g &= -9, Fe && Fe(t), u = f.render(f.props, f.state = f.__s, f.context);
      while (8 & f.__g && ++Ne < 25);
      b && (Pn.push.apply(f.__h, f.__k), f.__k = []), f.state = f.__s, f.getChildContext && (o = tt({}, o, f.getChildContext())), b && n.__c && f.getSnapshotBeforeUpdate && (x = f.getSnapshotBeforeUpdate(y, w)), ye = u && u.type === X && u.key == null ? u.props.children : u, _.__P && (u = s, r = (e = _.__P).namespaceURI, d = i = null, n.props && n.props.__P != e && (n.__k.some(function($) {
        $ && To($, $);
      }), n.__k = null), s = n.__k ? je(n, 0) : null), s = Jr(e, So(ye) ? ye : [ye], t, n, o, r, i, a, s, d, c), _.__P && (t.__e = null, s = u), t.__u &= -161, p && p.some(et), f.__h.length && a.push(f), 1 & f.__g && (f.__g &= -4);
    } catch ($) {
      if (a.length = m, t.__v = null, d || i) if ($ && $.then) {
        if (t.__u |= 128 | d, i) {
          for (~(v = i.indexOf(s || void 0)) || (v = i.length); (T = i[v - 1]) && T.nodeType == 8; ) v--;
          for (; v < i.length; v++) if (T = i[v]) if (i[v] = null, me) {
            if (T == h) break;
          } else {
            if (T.nodeType != 8) break;
            T.data.startsWith("$s") && (h = Cn(me = T));
          }
        }
        if (!me) {
          for (; s && s.nodeType == 8 && s.nextSibling; ) s = s.nextSibling;
          me = s;
        }
        (u = Cn(me = t.__c.__z || (t.__c.__z = me))) ? (t.__e = me, s = u) : t.__e = s, s = s && s.nextSibling;
      } else i && i.some(et);
      else t.__e = n.__e;
      t.__k || (t.__k = n.__k || []), $ && $.then || ei(t), M.__e($, t, n);
    }
  } else s = t.__e = as(n.__e, t, n, o, r, i, a, d, c, e);
  return (u = M.diffed) && u(t), s;
}
function Cn(e, t) {
  if (e && e.nodeType == 8 && e.data.startsWith("$s")) for (var n = 1; e = e.nextSibling; ) {
    if (e.nodeType == 8) {
      if (e.data.startsWith("$s")) n++;
      else if (e.data.startsWith("/$s") && !--n) return e;
    }
    t && t.push(e);
  }
}
function ei(e) {
  e && (e.__c && (e.__c.__g |= 4), e.__k && e.__k.some(ei));
}
function ti(e, t, n) {
  for (var o = 0; o < n.length; ) Eo(n[o++], n[o++], n[o++]);
  M.__c && M.__c(t, e), e.some(function(r) {
    try {
      e = r.__h, r.__h = [], e.some(function(i) {
        i.call(r);
      });
    } catch (i) {
      M.__e(i, r.__v);
    }
  });
}
function as(e, t, n, o, r, i, a, s, d, c) {
  var u, p, m, f, y, w, x, _, b = n.props || Tn, A = t.props, L = t.type;
  if (L == "svg" ? r = "http://www.w3.org/2000/svg" : L == "math" ? r = "http://www.w3.org/1998/Math/MathML" : r || (r = "http://www.w3.org/1999/xhtml"), i) {
    for (u = 0; u < i.length; u++) if ((y = i[u]) && (L ? y.localName == L : y.nodeType == 3)) {
      e = y, i[u] = null;
      break;
    }
  }
  if (!e) {
    if (_ = c.ownerDocument || document, !L) return _.createTextNode(A);
    e = _.createElementNS(r, L, A.is ? A : c), s && (M.__m && M.__m(t, i), s = !1), i = null;
  }
  if (L) {
    if (c = L == "template" && e.content || e, i = L == "textarea" && A.defaultValue != null ? null : i && Mo.call(c.childNodes), !s && i) for (b = {}, u = 0; u < e.attributes.length; u++) b[(y = e.attributes[u]).name] = y.value;
    for (u in b) y = b[u], u == "dangerouslySetInnerHTML" ? m = y : u == "children" || u in A || u == "value" && "defaultValue" in A || u == "checked" && "defaultChecked" in A || Sn(e, u, null, y, r);
    for (u in A) y = A[u], u == "children" ? f = y : u == "dangerouslySetInnerHTML" ? p = y : u == "value" ? w = y : u == "checked" ? x = y : s && typeof y != "function" || b[u] === y || Sn(e, u, y, b[u], r);
    p ? (s || m && (p.__html == m.__html || p.__html == e.innerHTML) || (e.innerHTML = p.__html), t.__k = []) : (m && (e.textContent = ""), (L == "foreignObject" || r == "http://www.w3.org/1998/Math/MathML" && ts.test(L)) && (r = "http://www.w3.org/1999/xhtml"), Jr(c, So(f) ? f : [f], t, n, o, r, i, a, i ? i[0] : n.__k && je(n, 0), s, d), i && i.some(et)), s && L != "textarea" || (u = "value", L == "progress" && w == null ? e.removeAttribute(u) : w == null || w === e[u] && (L != "progress" || w) || Sn(e, u, w, b[u], r), u = "checked", x != null && x != e[u] && Sn(e, u, x, b[u], r));
  } else b === A || s && e.data == A || (e.data = A);
  return e;
}
function Eo(e, t, n, o) {
  try {
    typeof e == "function" ? t ? t.__x = e(t) || 1 : o && (o = o.__c || o.__e) && (t = o.__x) && (o.__x = null, typeof t == "function" ? t() : e(null)) : e.current = t;
  } catch (r) {
    M.__e(r, n);
  }
}
function To(e, t, n) {
  var o, r, i, a;
  if (M.unmount && M.unmount(e), !(o = e.ref) || o.current && o.current != e.__e || Eo(o, null, t, e), o = e.__c) {
    if (o.componentWillUnmount) try {
      o.componentWillUnmount();
    } catch (s) {
      M.__e(s, t);
    }
    o.__P = o.__n = null;
  }
  if (o = e.__k) for (a = 0; a < o.length; a++) o[a] && To(o[a], t, typeof e.type != "function" || n && !e.props.__P);
  !n && (o = e.__c) && (o = o.__z) && (r = Cn(o, i = [])) && (o == e.__e && i.some(et), et(r), et(o)), n || et(e.__e), e.__e = e.__c = e.__ = null;
}
function ss(e, t, n) {
  return this.constructor(e, n);
}
function ni(e, t) {
  var n, o, r, i;
  M.__ && M.__(e, t), t.nodeType == 9 && (t = t.documentElement), o = (n = e && 32 & e.__u) ? null : t.__k, t.__k = Bt(X, { children: [e] }), r = [], i = [], Co(t, t.__k, o || Tn, Tn, t.namespaceURI, o ? null : t.firstChild ? Mo.call(t.childNodes) : null, r, o ? o.__e : t.firstChild, n, i), ti(r, t.__k, i), t.__k.props.children = null;
}
M = { __e: function(e, t, n, o) {
  for (var r, i, a; t = t.__; ) if ((r = t.__c) && !(1 & r.__g)) {
    r.__g |= 4;
    try {
      if ((a = (i = r.constructor) && i.getDerivedStateFromError) && r.setState(i.getDerivedStateFromError(e)), r.componentDidCatch && (r.componentDidCatch(e, o || {}), a = 1), a && 8 & r.__g) return void (r.__g |= 2);
    } catch (s) {
      e = s;
    }
  }
  throw En = 0, e;
} }, Br = 0, ko = function(e) {
  return e != null && e.constructor === zt;
}, gt.prototype.setState = function(e, t) {
  var n = this.__s;
  n && n != this.state || (n = this.__s = tt({}, this.state)), typeof e == "function" && (e = e(tt({}, n), this.props)), e && (tt(n, e), this.__v && (t && this.__k.push(t), Ur(this)));
}, gt.prototype.forceUpdate = function(e) {
  this.__v && (this.__g |= 4, e && this.__h.push(e), Ur(this));
}, gt.prototype.render = X, qe = [], En = 0, zr = function(e, t) {
  return e.__v.__b - t.__v.__b;
}, Mn = /* @__PURE__ */ Symbol(), Gr = /(PointerCapture)$|Capture$/i, xo = 0, wo = {}, es = 0;

// node_modules/preact/hooks/dist/hooks.mjs
var Xt, re, Po, oi, ls = Object.is, $o = 0, pi = [], Lo = [], N = M, ri = N.__b, ii = N.__r, ai = N.diffed, si = N.__c, li = N.unmount, ui = N.__;
function Io(e, t) {
  N.__h && N.__h(re, e, $o || t), $o = 0;
  var n = re.__H || (re.__H = { __: [], __h: [] });
  return e >= n.__.length && n.__.push({}), n.__[e];
}
function Se(e, t) {
  var n = Io(Xt++, 3);
  !N.__s && Ao(n.__H, t) && (n.__P = !0, n.__ = e, n.u = t, re.__H.__h.push(n));
}
function us(e, t) {
  var n = Io(Xt++, 4);
  !N.__s && Ao(n.__H, t) && (n.__P = !1, n.__ = e, n.u = t, re.__h.push(n));
}
function te(e) {
  return $o = 5, $n(function() {
    return { current: e };
  }, []);
}
function $n(e, t) {
  var n = Io(Xt++, 7);
  return Ao(n.__H, t) && (n.__ = e(), n.__H = t), n.__;
}
function cs() {
  var e;
  do {
    for (; e = Lo.shift(); ) try {
      Gt(e);
    } catch (n) {
      N.__e(n, { __: (e = e.__P) && e.__v });
    }
    for (; e = pi.shift(); ) {
      var t = e.__H;
      if (e.__P && t) try {
        t.__h.some(Gt), t.__h.some(Vo), t.__h = [];
      } catch (n) {
        t.__h = [], N.__e(n, e.__v);
      }
    }
  } while (Lo.length);
}
N.__b = function(e) {
  re = null, ri && ri(e);
}, N.__ = function(e, t) {
  e && t.__k && t.__k.__m && (e.__m = t.__k.__m), ui && ui(e, t);
}, N.__r = function(e) {
  ii && ii(e), Xt = 0;
  var t = (re = e.__c).__H;
  t && (Po == re ? re.__h = [] : (t.__h.some(Gt), t.__h.some(Vo), Xt = 0), t.__h = [], t.__.some(function(n) {
    n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
  })), Po = re;
}, N.diffed = function(e) {
  ai && ai(e);
  var t = e.__c;
  t && t.__H && (t.__H.__h.length && fi(pi.push(t)), t.__H.__.some(function(n) {
    n.u && (n.__H = n.u);
  })), Po = re = null;
}, N.__c = function(e, t) {
  t.some(function(n) {
    try {
      n.__h.some(Gt), n.__h = n.__h.filter(function(o) {
        return !o.__ || Vo(o);
      });
    } catch (o) {
      n.__h = [function() {
        throw o;
      }];
    }
  }), si && si(e, t);
}, N.unmount = function(e) {
  li && li(e);
  var t, n, o = e.__c;
  o && o.__H && (o.__H.__.some(function(r) {
    try {
      if (r.__P && r.__c) {
        if (n === void 0) {
          for (n = e.__; n && (!n.__c || !n.__c.__P); ) n = n.__;
          n = n && n.__c;
        }
        r.__P = n, fi(Lo.push(r));
      } else Gt(r);
    } catch (i) {
      t = i;
    }
  }), o.__H = void 0, t && N.__e(t, o.__v));
};
var ci = typeof requestAnimationFrame == "function";
function fs(e) {
  var t, n = function() {
    clearTimeout(o), ci && cancelAnimationFrame(t), setTimeout(e);
  }, o = setTimeout(n, 35);
  ci && (t = requestAnimationFrame(n));
}
function fi(e) {
  e != 1 && oi == N.requestAnimationFrame || ((oi = N.requestAnimationFrame) || fs)(cs);
}
function Gt(e) {
  var t = re, n = e.__c;
  typeof n == "function" && (e.__c = void 0, n()), re = t;
}
function Vo(e) {
  var t = re;
  e.__c = e.__(), re = t;
}
function Ao(e, t) {
  return !e || e.length != t.length || t.some(function(n, o) {
    return !ls(n, e[o]);
  });
}

// node_modules/@preact/signals-core/dist/signals-core.module.js
var ps = /* @__PURE__ */ Symbol.for("preact-signals");
function An() {
  if (Ae > 1)
    Ae--;
  else {
    var e, t = !1;
    for ((function() {
      var r = Vn;
      for (Vn = void 0; r !== void 0; ) {
        var i = r.S;
        if (i.v === r.v) for (var a = i.t; a !== void 0; a = a.x) a.i === r.i && (a.i = i.i);
        r = r.o;
      }
    })(); Qt !== void 0; ) {
      var n = Qt;
      for (Qt = void 0, Ln++; n !== void 0; ) {
        var o = n.u;
        if (n.u = void 0, n.f &= -3, !(8 & n.f) && mi(n)) try {
          n.c();
        } catch (r) {
          t || (e = r, t = !0);
        }
        n = o;
      }
    }
    if (Ln = 0, Ae--, t) throw e;
  }
}
function Rn(e) {
  if (Ae > 0) return e();
  Ro = ++ds, Ae++;
  try {
    return e();
  } finally {
    An();
  }
}
var Yt, H = void 0;
function ie(e) {
  var t = H, n = Yt;
  H = void 0, Yt = void 0;
  try {
    return e();
  } finally {
    H = t, Yt = n;
  }
}
var Qt = void 0, Ae = 0, Ln = 0, ds = 0, Ro = 0, Vn = void 0, In = 0;
function di(e) {
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
Y.prototype.brand = ps;
Y.prototype.h = function() {
  return !0;
};
Y.prototype.S = function(e) {
  var t = this, n = this.t;
  n !== e && e.e === void 0 && (e.x = n, this.t = e, n !== void 0 ? n.e = e : ie(function() {
    var o;
    (o = t.W) == null || o.call(t);
  }));
};
Y.prototype.U = function(e) {
  var t = this;
  if (this.t !== void 0) {
    var n = e.e, o = e.x;
    n !== void 0 && (n.x = o, e.e = void 0), o !== void 0 && (o.e = n, e.x = void 0), e === this.t && (this.t = o, o === void 0 && ie(function() {
      var r;
      (r = t.Z) == null || r.call(t);
    }));
  }
};
Y.prototype.subscribe = function(e) {
  var t = this;
  return C(function() {
    var n = t.value;
    ie(function() {
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
  return ie(function() {
    return e.value;
  });
};
Object.defineProperty(Y.prototype, "value", { get: function() {
  var e = di(this);
  return e !== void 0 && (e.i = this.i), this.v;
}, set: function(e) {
  if (e !== this.v) {
    if (Ln > 100) throw new Error("Cycle detected");
    (function(n) {
      Ae !== 0 && Ln === 0 && n.l !== Ro && (n.l = Ro, Vn = { S: n, v: n.v, i: n.i, o: Vn });
    })(this), this.v = e, this.i++, In++, Ae++;
    try {
      for (var t = this.t; t !== void 0; t = t.x) t.t.N();
    } finally {
      An();
    }
  }
} });
function g(e, t) {
  return new Y(e, t);
}
function mi(e) {
  for (var t = e.s; t !== void 0; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return !0;
  return !1;
}
function hi(e) {
  for (var t = e.s; t !== void 0; t = t.n) {
    var n = t.S.n;
    if (n !== void 0 && (t.r = n), t.S.n = t, t.i = -1, t.n === void 0) {
      e.s = t;
      break;
    }
  }
}
function vi(e) {
  for (var t = e.s, n = void 0; t !== void 0; ) {
    var o = t.p;
    t.i === -1 ? (t.S.U(t), o !== void 0 && (o.n = t.n), t.n !== void 0 && (t.n.p = o)) : n = t, t.S.n = t.r, t.r !== void 0 && (t.r = void 0), t = o;
  }
  e.s = n;
}
function nt(e, t) {
  Y.call(this, void 0, t), this.x = e, this.s = void 0, this.g = In - 1, this.f = 4;
}
nt.prototype = new Y();
nt.prototype.h = function() {
  if (this.f &= -3, 1 & this.f) return !1;
  if ((36 & this.f) == 32 || (this.f &= -5, this.g === In)) return !0;
  if (this.g = In, this.f |= 1, this.i > 0 && !mi(this))
    return this.f &= -2, !0;
  var e = H;
  try {
    hi(this), H = this;
    var t = this.x();
    (16 & this.f || this.v !== t || this.i === 0) && (this.v = t, this.f &= -17, this.i++);
  } catch (n) {
    this.v = n, this.f |= 16, this.i++;
  }
  return H = e, vi(this), this.f &= -2, !0;
};
nt.prototype.S = function(e) {
  if (this.t === void 0) {
    this.f |= 36;
    for (var t = this.s; t !== void 0; t = t.n) t.S.S(t);
  }
  Y.prototype.S.call(this, e);
};
nt.prototype.U = function(e) {
  if (this.t !== void 0 && (Y.prototype.U.call(this, e), this.t === void 0)) {
    this.f &= -33;
    for (var t = this.s; t !== void 0; t = t.n) t.S.U(t);
  }
};
nt.prototype.N = function() {
  if (!(2 & this.f)) {
    this.f |= 6;
    for (var e = this.t; e !== void 0; e = e.x) e.t.N();
  }
};
Object.defineProperty(nt.prototype, "value", { get: function() {
  if (1 & this.f) throw new Error("Cycle detected");
  var e = di(this);
  if (this.h(), e !== void 0 && (e.i = this.i), 16 & this.f) throw this.v;
  return this.v;
} });
function q(e, t) {
  return new nt(e, t);
}
function gi(e) {
  var t = e.j;
  if (e.j = void 0, typeof t == "function") {
    Ae++;
    var n = H;
    H = void 0;
    try {
      t();
    } catch (o) {
      throw e.f &= -2, e.f |= 8, Ho(e), o;
    } finally {
      H = n, An();
    }
  }
}
function Ho(e) {
  for (var t = e.s; t !== void 0; t = t.n) t.S.U(t);
  e.x = void 0, e.s = void 0, gi(e);
}
function ms(e) {
  if (H !== this) throw new Error("Out-of-order effect");
  vi(this), H = e, this.f &= -2;
  try {
    8 & this.f && Ho(this);
  } finally {
    An();
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
  this.f |= 1, this.f &= -9, gi(this), hi(this), Ae++;
  var e = H;
  return H = this, ms.bind(this, e);
};
bt.prototype.N = function() {
  2 & this.f || (this.f |= 2, this.u = Qt, Qt = this);
};
bt.prototype.d = function() {
  this.f |= 8, 1 & this.f || Ho(this);
};
bt.prototype.dispose = function() {
  this.d();
};
function C(e, t) {
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
var Ko, Zt, Hn, hs = typeof window < "u" && !!window.__PREACT_SIGNALS_DEVTOOLS__, bi = [], _i = [];
C(function() {
  Ko = this.N;
})();
function _t(e, t) {
  M[e] = t.bind(null, M[e] || function() {
  });
}
function Jt(e) {
  if (Hn) {
    var t = Hn;
    Hn = void 0, t();
  }
  Hn = e && e.S();
}
function yi(e) {
  var t = this, n = e.data, o = ot(n);
  o.name = "ReactiveDom", o.value = n;
  var r = $n(function() {
    for (var s = t, d = t.__v; d = d.__; ) if (d.__c) {
      d.__c.__$f |= 4;
      break;
    }
    var c = q(function() {
      var f = o.value.value;
      return f === 0 ? 0 : f === !0 ? "" : f || "";
    }), u = q(function() {
      return !Array.isArray(c.value) && !ko(c.value);
    }), p = C(function() {
      if (this.N = wi, u.value) {
        var f = c.value;
        s.__v && s.__v.__e && s.__v.__e.nodeType === 3 && (s.__v.__e.data = f);
      }
    }), m = t.__$u.d;
    return t.__$u.d = function() {
      p(), m.call(this);
    }, [u, c];
  }, []), i = r[0], a = r[1];
  return i.value ? a.peek() : a.value;
}
yi.displayName = "ReactiveTextNode";
Object.defineProperties(Y.prototype, { constructor: { configurable: !0, value: Xr(X, null).constructor }, type: { configurable: !0, value: yi }, props: { configurable: !0, get: function() {
  var e = this;
  return { data: { get value() {
    return e.value;
  } } };
} }, __b: { configurable: !0, value: 1 } });
_t("__b", function(e, t) {
  if (Jt(), Zt = void 0, typeof t.type == "string") {
    var n, o = t.props;
    for (var r in o) if (r !== "children") {
      var i = o[r];
      i instanceof Y && (n || (t.__np = n = {}), n[r] = i, o[r] = i.peek());
    }
  }
  e(t);
});
_t("__r", function(e, t) {
  if (e(t), t.type !== X) {
    Jt();
    var n, o = t.__c;
    o && (o.__$f &= -2, (n = o.__$u) === void 0 && (o.__$u = n = (function(r, i) {
      var a;
      return C(function() {
        a = this;
      }, { name: i }), a.c = r, a;
    })(/* @__PURE__ */ (function(r) {
      return function() {
        var i;
        hs && ((i = this.y) == null || i.call(this)), r.__$f |= 1, r.setState({});
      };
    })(o), typeof t.type == "function" ? t.type.displayName || t.type.name : ""))), Zt = o, Jt(n);
  }
});
_t("__e", function(e, t, n, o) {
  Jt(), Zt = void 0, e(t, n, o);
});
_t("diffed", function(e, t) {
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
      for (var d in o) {
        var c = i[d], u = o[d];
        c === void 0 ? (c = vs(n, d, u, r), i[d] = c) : c.o(u, r);
      }
    }
  }
  e(t);
});
function vs(e, t, n, o) {
  var r = t in e && e.ownerSVGElement === void 0, i = g(n);
  return { o: function(a, s) {
    i.value = a, o = s;
  }, d: C(function() {
    this.N = wi;
    var a = i.value.value;
    o[t] !== a && (o[t] = a, r ? e[t] = a : a != null && (a !== !1 || t[4] === "-") ? e.setAttribute(t, a) : e.removeAttribute(t));
  }) };
}
_t("unmount", function(e, t) {
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
      for (var d in a) s[d] = a[d];
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
_t("__h", function(e, t, n, o) {
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
function ot(e, t) {
  return $n(function() {
    return g(e, t);
  }, []);
}
var gs = typeof requestAnimationFrame > "u" ? setTimeout : function(e) {
  var t = function() {
    clearTimeout(n), cancelAnimationFrame(o), e();
  }, n = setTimeout(t, 35), o = requestAnimationFrame(t);
}, bs = function(e) {
  queueMicrotask(function() {
    queueMicrotask(e);
  });
};
function _s() {
  Rn(function() {
    for (var e; e = bi.shift(); ) Ko.call(e);
  });
}
function ys() {
  bi.push(this) === 1 && (M.requestAnimationFrame || gs)(_s);
}
function ws() {
  Rn(function() {
    for (var e; e = _i.shift(); ) Ko.call(e);
  });
}
function wi() {
  _i.push(this) === 1 && (M.requestAnimationFrame || bs)(ws);
}
function ki(e, t) {
  var n = te(e);
  n.current = e;
  var o = Zt;
  Se(function() {
    return C(function() {
      if (this.N = ys, !(o && 8 & o.__$f)) return n.current();
    }, t);
  }, []);
}

// src/store.ts
var Kn = /* @__PURE__ */ new Set(), yt = (e) => typeof e == "object" && e !== null && !Array.isArray(e);
function nn(e, t) {
  if (!yt(e) || !yt(t)) return t;
  let n = { ...e };
  for (let [o, r] of Object.entries(t)) n[o] = nn(n[o], r);
  return n;
}
var en = class {
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
      this.own.set(o, { value: nn(i, r), seq: n });
    }
    Kn.add(this), this.show();
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
    this.own.size === 0 && Kn.delete(this), n && this.show();
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
}, Me = class {
  /** Numbers of the entries there are, ascending; changes only when one comes or goes. */
  ids = g([]);
  entries = /* @__PURE__ */ new Map();
  get(t) {
    if (t == null) return;
    let n = this.entries.get(t);
    if (n) return n.shown.value;
    this.ids.value;
  }
  entry(t) {
    return this.entries.get(t);
  }
  /** All entries; whoever asks inside of an effect hears of each change. */
  all() {
    return this.ids.value.map((t) => [t, this.entries.get(t).shown.value]);
  }
  whole(t) {
    let n = /* @__PURE__ */ new Map();
    for (let [o, r] of Object.entries(t ?? {})) n.set(Number(o), new en(r));
    this.entries = n, this.number();
  }
  patch(t) {
    let n = !1;
    for (let [o, r] of Object.entries(t)) {
      let i = Number(o), a = this.entries.get(i);
      r === null ? n = this.entries.delete(i) || n : a ? a.receive(r) : (this.entries.set(i, new en(r)), n = !0);
    }
    n && this.number();
  }
  number() {
    this.ids.value = [...this.entries.keys()].sort((t, n) => t - n);
  }
}, k = new Me(), K = new Me(), he = new Me(), wt = new Me(), kt = new Me(), xt = new Me(), St = new Me(), Dn = new Me(), tn = {
  lamps: k,
  groups: K,
  things: he,
  materials: wt,
  views: kt,
  looks: xt,
  meters: St,
  grids: Dn
}, J = g(null), on = g([]), we = g([]), rt = g({ undo: null, redo: null, steps: 0 }), it = g({ state: "clean", file: "" }), j = g({ you: !0, name: null }), Ce = g(null), On = new en({
  ev: null,
  metered: !1,
  tone: "filmic",
  white: null,
  false_color: null
}), at = On.shown, Do = {
  scene: J,
  layers: on,
  solo: we,
  history: rt,
  saved: it,
  editor: j,
  status: Ce
};
function xi(e) {
  Kn.clear();
  for (let [t, n] of Object.entries(tn)) n.whole(e[t]);
  for (let [t, n] of Object.entries(Do)) t in e && (n.value = e[t]);
  yt(e.display) && On.receive(e.display);
}
function Si(e, t) {
  for (let [n, o] of Object.entries(e))
    n in tn ? tn[n].patch(o) : n === "display" ? On.receive(o) : n in Do && (Do[n].value = o);
  Mt(t);
}
function Mt(e) {
  for (let t of [...Kn]) t.release(e);
}
function Mi(e, t) {
  for (let [n, o] of Object.entries(e))
    if (n in tn && yt(o))
      for (let [r, i] of Object.entries(o)) {
        let a = tn[n].entry(Number(r));
        a && yt(i) && t(a, i);
      }
    else n === "display" && yt(o) && t(On, o);
}
var Oo = (e, t) => Mi(e, (n, o) => n.keep(o, t)), Fn = (e, t) => Mi(e, (n, o) => n.settle(o, t));
function Re(e) {
  let t = K.get(e.group);
  return e.on && !e.parked && (t?.on ?? !0) ? e.level * (t?.level ?? 1) : 0;
}
var Ci = q(() => {
  let e = k.all();
  return e.length > 0 && e.every(([, t]) => Re(t) === 0);
});
function ks(e, t) {
  let n = t.trim().toLowerCase();
  return e.all().filter(([, o]) => !n || o.name.toLowerCase().includes(n));
}

// src/say.ts
var st = g([]), xs = 0;
function ae(e, t = "plain") {
  if (st.peek().find((r) => r.text === e)) return;
  let o = ++xs;
  st.value = [...st.peek().slice(-2), { id: o, text: e, tone: t }], setTimeout(() => Fo(o), t === "warn" ? 8e3 : 4e3);
}
function Fo(e) {
  st.value = st.peek().filter((t) => t.id !== e);
}

// src/counters.ts
var se = {
  frame: 0,
  seqApplied: 0,
  frames: [],
  sent: [],
  entered: 0,
  firstDrawn: 0
}, Ei = 0;
for (let e of ["input", "pointermove", "pointerdown", "keydown", "wheel"])
  addEventListener(e, (t) => Ei = t.timeStamp, { capture: !0, passive: !0 });
function Ti(e, t) {
  se.sent.push({ seq: e, what: t, at: performance.now(), input: Ei }), se.sent.length > 1024 && se.sent.shift();
}
function Pi(e) {
  se.frame = e.frame, se.seqApplied = e.seq, se.firstDrawn ||= e.drawn, se.frames.push(e), se.frames.length > 1024 && se.frames.shift(), requestAnimationFrame(() => {
    let t = new MessageChannel();
    t.port1.onmessage = () => {
      e.painted = performance.now(), t.port1.close();
    }, t.port2.postMessage(0);
  });
}
window.__desk = se;

// src/wire.ts
var U = g("entering"), sn = g(0), fe = g("edit"), jo = g(null), He = g(0), $i = () => null, Li = (e) => {
  $i = e;
}, Nn = /* @__PURE__ */ new Map(), Ue = null, rn = 0, No = null, an = 0, Ct = "", qn = !1;
function ke(e, t) {
  let n = Nn.get(e) ?? /* @__PURE__ */ new Set();
  return Nn.set(e, n.add(t)), () => n.delete(t);
}
function D(e) {
  return !Ue || Ue.readyState !== WebSocket.OPEN || U.peek() !== "open" ? 0 : (rn += 1, Ue.send(JSON.stringify({ ...e, seq: rn })), e.do !== "ack" && Ti(rn, e.do), rn);
}
var Ss = 0, lt = /* @__PURE__ */ new Map();
function xe(e, t, n, o = () => {
}) {
  let r = ++Ss, i = ke("answer", (s) => {
    s.id === r && (s.done !== !1 && i(), n(s));
  }), a = D({ do: "ask", id: r, what: e, ...t });
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
function Ms(e) {
  switch (e.is) {
    case "hello":
      if (an = 0, No !== null && e.build !== No) {
        U.value = "renewed", Ue?.close();
        return;
      }
      No = e.build, fe.value = e.role === "watch" ? "watch" : "edit", jo.value = e.you === void 0 ? null : String(e.you), He.value = 0, lt.clear(), U.value = "open";
      break;
    case "state":
      xi(e.state ?? e);
      break;
    case "patch":
      qo(e.seq), Si(e.patch ?? {}, He.value);
      break;
    case "status":
      Ce.value = e;
      break;
    case "refused":
      if (qo(e.seq), Mt(He.value), lt.has(e.seq)) {
        lt.get(e.seq)?.(e.why ?? ""), lt.delete(e.seq);
        return;
      }
      break;
    case "event":
      e.what === "bye" && (qn = !0);
      break;
  }
  for (let t of [...Nn.get(e.is) ?? []]) t(e);
}
function qo(e) {
  typeof e == "number" && e > He.value && (He.value = e);
}
async function Vi() {
  if (!Ct) return "in";
  try {
    return (await fetch("/enter", {
      method: "POST",
      headers: { "content-type": "application/json" },
      body: JSON.stringify({ key: Ct })
    })).ok ? "in" : "denied";
  } catch {
    return "away";
  }
}
function Ii() {
  let e = location.protocol === "https:" ? "wss" : "ws", t = new WebSocket(`${e}://${location.host}/wire`);
  t.binaryType = "arraybuffer";
  let n = !1;
  Ue = t, Nn.get("line")?.forEach((o) => o({ is: "line" })), t.onmessage = (o) => {
    if (t !== Ue) return;
    if (typeof o.data != "string") {
      let i = $i(o.data);
      i && qo(i.seq);
      return;
    }
    let r = JSON.parse(o.data);
    r.is === "hello" && (n = !0, rn = 0), Ms(r);
  }, t.onclose = () => {
    t === Ue && (Ue = null, U.value !== "renewed" && Cs(n));
  };
}
async function Cs(e) {
  if (Mt(1 / 0), !e && await Es()) {
    let o = await Vi();
    if (o === "denied" || o === "in" && an > 4 && !Ct) {
      U.value = "denied";
      return;
    }
  }
  an += 1;
  let t = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
  an > 3 && t && (qn = !0), U.value = qn ? "ended" : "lost";
  let n = Math.min(5, an);
  for (let o = n; o > 0; o--)
    sn.value = o, await new Promise((r) => setTimeout(r, 1e3));
  sn.value = 0, Ii();
}
async function Es() {
  try {
    return (await fetch("/", { method: "HEAD", cache: "no-store" })).ok;
  } catch {
    return !1;
  }
}
async function Ai() {
  let e = location.hash.slice(1);
  if (e ? (Ct = e, sessionStorage.setItem("lampyris-key", Ct), window.history.replaceState(null, "", location.pathname + location.search)) : Ct = sessionStorage.getItem("lampyris-key") ?? "", se.entered = performance.now(), e && await Vi() === "denied") {
    U.value = "denied";
    return;
  }
  Ii();
}
ke("hello", () => qn = !1);

// src/gesture.ts
var Et = 0, Ki = /* @__PURE__ */ new Set(), Di = (e) => {
  Ki.add(e);
}, ln = /* @__PURE__ */ new Set();
function jn() {
  return U.value !== "open" ? "There is no connection to the program: nothing was changed." : fe.value === "watch" ? "You are watching. Ask for the pen to change things." : j.value.you ? null : `${j.value.name ?? "Somebody else"} has the pen. Take it to change things.`;
}
var Ri = (e) => (e.length > 120 ? `${e.slice(0, 119)}…` : e).replace(/[\u0000-\u001f]/g, " "), We = class {
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
    this.state === "over" || !this.begin() || (Oo(t, 1 / 0), this.touched = nn(this.touched, t), this.waiting = nn(this.waiting ?? {}, t), this.under <= He.peek() && this.flush());
  }
  /** Any other message that belongs to this step. */
  also(t) {
    this.state === "over" || !this.begin() || (this.flush(), this.last = D(t));
  }
  end(t) {
    this.state === "held" && (this.flush(), Fn(this.touched, this.last), this.finish({ do: "end", ...t ? { label: Ri(t) } : {} })), this.state = "over";
  }
  cancel() {
    this.state === "held" && (this.waiting = null, Fn(this.touched, 0), this.finish({ do: "cancel" }), Mt(0)), this.state = "over";
  }
  /** The server has followed so far. */
  followed() {
    this.waiting && this.under <= He.peek() && this.flush();
  }
  /** The line is gone, and with it what was held. */
  drop() {
    this.state = "over", ln.delete(this), Et = 0;
  }
  begin() {
    if (this.state === "held") return !0;
    let t = ie(jn);
    return t ? (ae(t, "warn"), this.state = "over", !1) : (this.state = "held", ln.add(this), Et === 0 && Ki.forEach((n) => n()), Et++ === 0 && (this.last = D({ do: "begin", label: Ri(this.label) })), !0);
  }
  flush() {
    this.waiting && (this.under = this.last = D({ do: "set", patch: this.waiting }), this.waiting = null);
  }
  finish(t) {
    ln.delete(this), Et = Math.max(0, Et - 1), Et === 0 && D(t);
  }
};
function Te(e, t) {
  let n = new We(e);
  n.set(t), n.end();
}
function Ts(e, t) {
  let n = new We(e);
  n.also(t), n.end();
}
function Tt(e) {
  ie(() => U.value) === "open" && (Oo({ display: e }, 1 / 0), Fn({ display: e }, D({ do: "display", patch: e })));
}
var Ee = null;
function Uo(e, t, n) {
  Ee && Ee.key !== e && Hi(), Ee ??= { key: e, gesture: new We(t), timer: 0 }, Ee.gesture.set(n), clearTimeout(Ee.timer), Ee.timer = window.setTimeout(Hi, 700);
}
function Hi() {
  Ee && (clearTimeout(Ee.timer), Ee.gesture.end(), Ee = null);
}
C(() => {
  He.value, ie(() => [...ln].forEach((e) => e.followed()));
});
C(() => {
  U.value !== "open" && [...ln].forEach((e) => e.drop());
});

// src/vec.ts
var V = (e, t) => [e[0] + t[0], e[1] + t[1], e[2] + t[2]], O = (e, t) => [e[0] - t[0], e[1] - t[1], e[2] - t[2]], S = (e, t) => [e[0] * t, e[1] * t, e[2] * t], F = (e, t) => e[0] * t[0] + e[1] * t[1] + e[2] * t[2], ve = (e, t) => [
  e[1] * t[2] - e[2] * t[1],
  e[2] * t[0] - e[0] * t[2],
  e[0] * t[1] - e[1] * t[0]
], Ke = (e) => Math.hypot(e[0], e[1], e[2]), De = (e, t) => Ke(O(e, t)), Ps = (e, t, n) => V(S(e, 1 - n), S(t, n));
function Z(e, t = [0, 0, 1]) {
  let n = Ke(e);
  return n > 1e-12 ? S(e, 1 / n) : t;
}
function ut(e) {
  let t = Math.abs(e[0]) < 0.7 * Ke(e) ? [1, 0, 0] : [0, 1, 0];
  return Z(ve(t, e));
}
function un(e, t, n) {
  let o = Math.cos(n), r = Math.sin(n);
  return V(V(S(e, o), S(ve(t, e), r)), S(t, F(t, e) * (1 - o)));
}
function Pt([e, t]) {
  return Array.from({ length: 8 }, (n, o) => [
    o & 1 ? t[0] : e[0],
    o & 2 ? t[1] : e[1],
    o & 4 ? t[2] : e[2]
  ]);
}
var Be = ([e, t]) => Ps(e, t, 0.5);

// src/camera.ts
var Wo = Math.PI / 180, Un = 89 * Wo;
function $t(e, t, n) {
  let o = Z(O(e.target, e.eye), [0, 0, -1]), r = Z(ve(o, e.up), ut(o)), i = ve(r, o), a = e.height != null && e.height > 0, s = a ? e.height / n : 2 * Math.tan(e.fov * Wo * 0.5) / n;
  return { eye: e.eye, forward: o, side: r, up: i, width: t, height: n, pixel: s, parallel: a };
}
function cn(e, t) {
  let n = O(t, e.eye), o = F(n, e.forward), r = e.parallel ? e.pixel : e.pixel * o;
  return [e.width / 2 + F(n, e.side) / r, e.height / 2 - F(n, e.up) / r, o];
}
function $s(e, t, n) {
  let o = (t - e.width / 2) * e.pixel, r = (e.height / 2 - n) * e.pixel, i = V(S(e.side, o), S(e.up, r));
  return e.parallel ? { origin: V(e.eye, i), direction: e.forward } : { origin: e.eye, direction: Z(V(e.forward, i)) };
}
function Oi(e, t, n, o) {
  let r = O(e.target, e.eye), i = Math.max(Ke(r), 1e-3), a = Math.asin(Math.max(-1, Math.min(1, F(Z(r), t)))), s = O(r, S(t, F(r, t))), d = Z(Ke(s) > 1e-6 * i ? s : O(e.up, S(t, F(e.up, t))), ut(t)), c = Math.max(-Un, Math.min(Un, a + o)), u = un(d, t, n), p = V(S(u, Math.cos(c)), S(t, Math.sin(c)));
  return { ...e, up: t, target: V(e.eye, S(p, i)) };
}
function Fi(e, t, n, o, r) {
  let i = O(e.target, e.eye), a = O(i, S(t, F(i, t))), s = Z(Ke(a) > 1e-6 ? a : e.up, ut(t)), d = Z(ve(s, t)), c = V(V(S(s, n), S(d, o)), S(t, r));
  return ze(e, c);
}
function Ni(e, t, n, o, r) {
  let i = Z(O(e.target, e.eye)), a = Z(ve(i, e.up), ut(i));
  return ze(e, V(V(S(i, n), S(a, o)), S(t, r)));
}
function ze(e, t) {
  return { ...e, eye: V(e.eye, t), target: V(e.target, t) };
}
function qi(e, t, n, o, r) {
  let i = Z(O(e.target, e.eye)), a = Math.asin(Math.max(-1, Math.min(1, F(i, t)))), s = Math.max(-Un, Math.min(Un, a + r)), d = Z(ve(i, t), Z(ve(i, e.up), ut(i))), c = (u) => un(un(u, d, s - a), t, o);
  return {
    ...e,
    up: t,
    eye: V(n, c(O(e.eye, n))),
    target: V(n, c(O(e.target, n)))
  };
}
function ji(e, t, n, o, r) {
  let i = t.parallel ? t.pixel : t.pixel * r;
  return ze(e, V(S(t.side, -n * i), S(t.up, o * i)));
}
function Wn(e, t, n, o, r) {
  let i = O(t, e.eye), a = Ke(i);
  if (a < 1e-9) return e;
  let s = a * (1 - n);
  return r ? s = Math.sign(s) * Math.max(Math.abs(s), 0.5 * Math.abs(1 - n)) : s > 0 && (s = Math.max(0, Math.min(s, a - o))), ze(e, S(i, s / a));
}
function Bn(e, t, n, o, r) {
  let i = Math.max(0.05, Math.min(1e5, (e.height ?? 1) * r)), a = (1 - i / (e.height ?? 1)) * t.pixel, s = V(
    S(t.side, (n - t.width / 2) * a),
    S(t.up, (t.height / 2 - o) * a)
  );
  return { ...ze(e, s), height: i };
}
function Ui(e, t, n = 0.4) {
  let o = Be(t), r = Math.max(De(t[0], t[1]) / 2, 0.15), i = Z(O(e.eye, e.target));
  if (e.height) {
    let s = F(O(e.eye, o), i);
    return { ...e, eye: V(o, S(i, s)), target: o, height: r * 3 };
  }
  let a = Math.max(1.5 * r / Math.tan(e.fov * Wo * 0.5), n + r);
  return { ...e, eye: V(o, S(i, a)), target: o };
}
var Ls = ["plan", "ceiling", "north", "east", "south", "west"];
function Wi(e) {
  let t = Math.abs(e[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], n = Z(ve(e, t));
  return { right: Z(ve(n, e)), ahead: n };
}
function Bi(e, t, n, o) {
  let { right: r, ahead: i } = Wi(n), a = Be(t), s = (y) => Math.abs(F(O(t[1], t[0]), y)), c = {
    plan: { forward: S(n, -1), up: i, side: r, cut: 0.15 },
    ceiling: { forward: n, up: S(i, -1), side: r, cut: 0.35 },
    north: { forward: i, up: n, side: r, cut: 0.25 },
    south: { forward: S(i, -1), up: n, side: r, cut: 0.25 },
    east: { forward: r, up: n, side: i, cut: 0.25 },
    west: { forward: S(r, -1), up: n, side: i, cut: 0.25 }
  }[e], u = s(c.forward), p = 1, m = O(a, S(c.forward, u / 2 + p)), f = 1.08 * Math.max(s(c.up), s(c.side) / o, 0.1);
  return { eye: m, target: a, up: c.up, fov: 50, height: f, near: p + u * c.cut };
}
function fn(e, t) {
  let n = (r, i) => De(r, i) < 1e-4, o = (r, i) => Math.abs((r ?? -1) - (i ?? -1)) < 1e-4;
  return n(e.eye, t.eye) && n(e.target, t.target) && n(e.up, t.up) && o(e.fov, t.fov) && o(e.height, t.height) && o(e.near, t.near);
}

// src/frames.ts
var W = g(null), Vt = g(0), zi = ["moving", "settled", "final"], Gi = 32, Lt = /* @__PURE__ */ new Map(), Pe = null, Bo = null, zo = !1, ct = null;
function Vs(e) {
  if (e.byteLength < Gi) return null;
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
function Is(e) {
  let t = Vs(e);
  return t ? (ct && D({ do: "ack", frame: ct.head.frame }), ct = { ...t, bytes: e, received: performance.now() }, zo || As(), t.head) : null;
}
async function As() {
  for (zo = !0; ct; ) {
    let { head: e, mime: t, bytes: n, received: o } = ct;
    ct = null;
    try {
      let r = await createImageBitmap(new Blob([new Uint8Array(n, Gi)], { type: t }));
      Rs(e, r, n.byteLength, o);
    } catch {
    }
    D({ do: "ack", frame: e.frame });
  }
  zo = !1;
}
function Rs(e, t, n, o) {
  let r = performance.now();
  Pe && Bo && ((Pe.width !== t.width || Pe.height !== t.height) && (Pe.width = t.width, Pe.height = t.height), Bo.drawImage(t, 0, 0)), t.close();
  let i = Lt.get(e.camera) ?? W.peek()?.camera;
  i && (W.value = { head: e, camera: i }), Hs(), Pi({
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
function Hs() {
  let e = performance.now();
  zn = zn.filter((t) => e - t < 1e3), zn.push(e), Vt.value = zn.length;
}
function Go(e) {
  Pe = e, Bo = e?.getContext("2d", { alpha: !1 }) ?? null;
}
function Xi() {
  if (!Pe || !W.peek()) return null;
  let e = document.createElement("canvas");
  return e.width = Pe.width, e.height = Pe.height, e.getContext("2d", { alpha: !1 })?.drawImage(Pe, 0, 0), e;
}
Li(Is);
ke("camera", (e) => {
  Lt.set(e.number, e);
  for (let t of Lt.keys()) {
    if (Lt.size <= 64) break;
    Lt.delete(t);
  }
});
ke("line", () => {
  Lt.clear(), ct = null;
});

// src/prefs.ts
var Yi = "lampyris-";
function ue(e, t) {
  let n = t;
  try {
    let r = localStorage.getItem(Yi + e);
    r !== null && (n = JSON.parse(r));
  } catch {
  }
  let o = g(n);
  return C(() => {
    let r = JSON.stringify(o.value);
    try {
      localStorage.setItem(Yi + e, r);
    } catch {
    }
  }), o;
}
var Xo = ue("theme", "dark"), Yo = ue("house-lights", 1), Gn = ue("hands", "default"), Qo = ue("walking", "walk"), Jo = ue("panels", !0), It = ue("listing", "faders"), Xn = ue("travel", "square"), At = ue("candles", "lx"), Zo = ue("single-keys", !0), er = ue("lamp-marks", !0), Ks = ue("maintenance", 1), Ge = ue("fine", !1), tr = ue("fade", 1), Ds = typeof matchMedia == "function" && matchMedia("(pointer: coarse)").matches, $e = ue("look-only", Ds);

// src/select.ts
var E = g(null), pe = g(null), z = g(null), Os = g("move"), le = q(() => {
  let e = E.value;
  return e?.kind === "lamp" ? e.ids.filter((t) => k.get(t)) : e?.kind === "group" ? e.ids.flatMap((t) => K.get(t)?.lamps ?? []) : [];
});
function Xe(e, t, n = "only") {
  let o = E.peek();
  if (n === "only" || o?.kind !== e) {
    E.value = { kind: e, ids: [t] };
    return;
  }
  let r = o.ids.includes(t);
  if (r && n === "add") return;
  let i = r ? o.ids.filter((a) => a !== t) : [...o.ids, t];
  E.value = i.length ? { kind: e, ids: i } : null;
}
function Yn() {
  E.value = null;
}
function Qi(e, t, n) {
  let o = E.peek(), r = o?.kind === e ? t.indexOf(o.ids[o.ids.length - 1]) : -1;
  if (r < 0) return Xe(e, n);
  let i = t.indexOf(n), [a, s] = r < i ? [r, i] : [i, r], d = t.slice(a, s + 1), c = (o?.ids ?? []).filter((u) => !d.includes(u));
  E.value = { kind: e, ids: [...c, ...r < i ? d : d.reverse()] };
}
function Fs(e) {
  let t = E.peek(), n = t?.kind ?? "lamp", o = n === "lamp" ? k.ids.peek() : n === "thing" ? he.ids.peek() : K.ids.peek();
  if (!o.length) return;
  let r = t ? o.indexOf(t.ids[t.ids.length - 1]) : e > 0 ? -1 : 0;
  Xe(n, o[(r + e + o.length) % o.length]);
}
function Ji(e, t) {
  switch (e) {
    case "lamp":
      return k.get(t)?.name ?? `lamp ${t}`;
    case "group":
      return K.get(t)?.name ?? `group ${t}`;
    case "thing":
      return he.get(t)?.name ?? `thing ${t}`;
    case "material":
      return wt.get(t)?.name ?? `material ${t}`;
    default:
      return `${e} ${t}`;
  }
}
function Qn(e) {
  return e.length === 1 ? Ji("lamp", e[0]) : `${e.length} lamps`;
}
function Zi(e, t) {
  let n = [];
  if (e?.lamp != null) {
    n.push({ kind: "lamp", ids: [e.lamp] });
    let i = k.get(e.lamp)?.group;
    i != null && (K.get(i)?.lamps.length ?? 0) > 1 && n.push({ kind: "group", ids: [i] });
  }
  if (e?.thing != null && n.push({ kind: "thing", ids: [e.thing] }), !n.length) {
    t === "only" && Yn();
    return;
  }
  if (t !== "only") return Xe(n[0].kind, n[0].ids[0], t);
  let o = E.peek(), r = n.findIndex((i) => o?.kind === i.kind && o.ids.length === 1 && o.ids[0] === i.ids[0]);
  E.value = n[(r + 1) % n.length];
}
var Jn = g(null);

// src/navigate.ts
var Ns = 1.6, ge = g(null), ta = q(() => fe.value === "edit" && j.value.you), Le = q(() => J.value?.up ?? [0, 0, 1]), be = g([640, 480]), Kt = g(null), rr = null, pn = null, nr = !1, Ye = [], ar = [], ir = 0;
function Q(e, t = null) {
  let n = ge.peek();
  if (n && fn(n, e)) return;
  let o = performance.now();
  n && (o - ir > 1e3 || t) && (Ye.push(n), Ye.length > 100 && Ye.shift(), ar.length = 0), ir = o, ge.value = e, Kt.value = t;
}
var ne = () => ge.peek();
function qs() {
  na(Ye, ar);
}
function js() {
  na(ar, Ye);
}
function na(e, t) {
  let n = e.pop();
  if (!n) return;
  let o = ge.peek();
  o && t.push(o), ir = performance.now(), ge.value = n, Kt.value = null;
}
C(() => {
  !ge.value || U.value !== "open" || !ta.value || nr || (nr = !0, requestAnimationFrame(() => {
    nr = !1;
    let t = ge.peek();
    if (!t || pn && fn(pn, t)) return;
    let { eye: n, target: o, up: r, fov: i, height: a, near: s } = t, d = { do: "camera", eye: n, target: o, up: r, fov: i };
    a && (d.height = a), s && (d.near = s), D(d) && (pn = t);
  }));
});
C(() => {
  let e = W.value;
  e && ie(() => {
    ge.peek() && ta.peek() || (pn = e.camera, ge.value = e.camera, rr ??= e.camera);
  });
});
ke("hello", () => pn = null);
function Dt(e, t) {
  let n = W.peek();
  if (!n) return null;
  let { head: o } = n, r = dn(o.width, o.height);
  return { frame: o.frame, x: (e - r.x) / r.scale, y: (t - r.y) / r.scale };
}
function dn(e, t) {
  let [n, o] = be.peek(), r = Math.min(n / e, o / t);
  return { x: (n - e * r) / 2, y: (o - t * r) / 2, scale: r };
}
function ft(e = ge.peek()) {
  let [t, n] = be.peek();
  return e ? $t(e, t, n) : null;
}
var Ht = () => J.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]], Ot = () => Be(Ht());
function Zn(e, t) {
  let n = ne();
  n && Q(Oi(n, Le.peek(), e, t));
}
function eo(e, t, n) {
  let o = ne();
  o && Q(qi(o, Le.peek(), e, t, n));
}
function Ft(e, t, n) {
  let o = ne(), r = ft();
  o && r && Q(ji(o, r, e, t, n));
}
function oa(e, t, n) {
  let o = ne();
  if (o) {
    if (o.height) {
      let r = ft(o);
      r && Q(ze(o, V(S(r.side, t), S(r.up, e))));
      return;
    }
    Qo.peek() === "fly" || n !== 0 ? Q(Ni(o, Le.peek(), e, t, n)) : (Q(Fi(o, Le.peek(), e, t, 0)), Us());
  }
}
var Rt = !1, or = !0, ea = null;
function Us() {
  let e = ne();
  if (!e || Rt || !or) return;
  let t = Le.peek();
  Rt = !0;
  let n = xe("ray", { origin: e.eye, direction: S(t, -1) }, (o) => {
    Rt = !1, or = !0;
    let r = ne();
    if (!o.hit || !r || r.height) return;
    ea = F(o.point, t);
    let i = ea + Ns - F(r.eye, t);
    Math.abs(i) > 0.01 && Q(ze(r, S(t, i * 0.5)));
  }, () => {
    Rt = !1, or = !1;
  });
  setTimeout(() => {
    Rt && n(), Rt = !1;
  }, 500);
}
function Ws() {
  let e = E.peek();
  if (!e) return null;
  let t = [], n = (i, a) => {
    i ? t.push(i) : a && t.push([a, a]);
  };
  for (let i of e.ids)
    if (e.kind === "lamp" && n(k.get(i)?.box, k.get(i)?.place?.position), e.kind === "thing" && n(he.get(i)?.box), e.kind === "meter" && n(null, St.get(i)?.point), e.kind === "group")
      for (let a of K.get(i)?.lamps ?? []) n(k.get(a)?.box, k.get(a)?.place?.position);
  if (!t.length) return null;
  let o = t.flatMap(Pt), r = (i) => [0, 1, 2].map((a) => i(...o.map((s) => s[a])));
  return [r(Math.min), r(Math.max)];
}
function sr() {
  let e = ne(), t = Ws();
  e && t ? Q(Ui(e, t), "selection") : lr();
}
function lr() {
  rr && Q(rr, "home");
}
function Bs(e) {
  let [t, n] = be.peek();
  Q(Bi(e, Ht(), Le.peek(), t / n), e);
}
function zs() {
  for (let e = Ye.length - 1; e >= 0; e--)
    if (!Ye[e].height) return Q(Ye[e], "inside");
  lr();
}
var Gs = q(() => {
  let e = ge.value;
  if (!e?.height) return null;
  let t = $t(e, 2, 2), n = Pt(Ht()).map((s) => F(O(s, e.eye), t.forward)), o = e.near ?? 0, r = F(t.forward, Le.value), i = Math.min(...Pt(Ht()).map((s) => F(s, Le.value))), a = Math.abs(r) > 0.99 ? F(e.eye, Le.value) + r * o - i : null;
  return { value: o, most: Math.max(...n), height: a };
});
function Xs(e) {
  let t = ne();
  t && (ge.value = { ...t, near: Math.max(0, e) });
}

// src/tools.ts
var ur = g("spot"), ra = () => {
}, Ys = (e) => {
  ra = e;
}, ia = (e) => ra(e);
function cr(e) {
  z.value = z.peek() === e ? null : e;
}
var to = (e) => Math.max(-1, ...e.ids.peek()) + 1;
function fr(e) {
  return e.kind === "sky" || e.kind === "parallel" ? null : e.place?.position ?? (e.box ? Be(e.box) : null);
}

// src/actions.ts
var pt = g(null), Ve = g("lamps"), dr = g("");
function oo(e) {
  let t = jn();
  t ? ae(t, "warn") : D(e);
}
var Qs = (e, t) => Object.fromEntries(e.map((n) => [n, t])), Js = {
  quantity: "illuminance",
  low: 1,
  high: 1e3,
  scale: "log",
  palette: "viridis",
  lines: !1
}, pr = Js, Zs = () => at.peek().false_color ?? pr;
function mr() {
  let e = at.peek().false_color;
  e && (pr = e), Tt({ false_color: e ? null : pr });
}
function ro(e) {
  let t = Math.round(((at.peek().ev ?? 0) + e / 3) * 30) / 30;
  Tt({ ev: t });
}
function el() {
  let e = ne();
  if (!e) return;
  let t = to(kt);
  Te("Store the view", { views: { [t]: { ...e, name: `View ${t + 1}` } } });
}
var tl = () => oo({ do: "look", what: "store", name: `Look ${to(xt) + 1}` });
async function hr(e) {
  let t = !1;
  try {
    await navigator.clipboard.writeText(e), t = !0;
  } catch {
    let n = document.createElement("textarea");
    n.value = e, n.className = "spoken", document.body.append(n), n.select(), t = document.execCommand("copy"), n.remove();
  }
  ae(t ? "Copied." : `Copy it by hand: ${e}`);
}
var Nt = /* @__PURE__ */ new Map(), no = null;
function nl(e) {
  Nt = new Map(e.map((t) => [t.id, t])), no && oe(no), no = null;
}
var ol = () => [...Nt.values()], aa = (e) => Nt.get(e), vr = (e) => Nt.get(e)?.why?.() ?? null;
function oe(e) {
  let t = Nt.get(e);
  Nt.size || (no = e);
  let n = t?.why?.();
  n ? ae(n, "warn") : t?.run();
}

// src/before.ts
var mn = g(null), de = g(null), rl = g(0.5);
function il() {
  let e = W.peek(), t = Xi();
  e && t && (mn.value = { picture: t, camera: e.camera });
}
Di(() => {
  de.peek() !== "wipe" && il();
});
function sa() {
  let e = mn.peek(), t = W.peek();
  if (!e || !t) ae("Nothing has been changed yet.");
  else if (!fn(e.camera, t.camera)) ae("The picture before was taken from another place: go back there with Alt+←.", "warn");
  else return !0;
  return !1;
}
function hn(e) {
  e ? de.peek() === null && sa() && (de.value = "held") : de.peek() === "held" && (de.value = null);
}
function al() {
  de.value = de.peek() === "wipe" ? null : sa() ? "wipe" : null;
}

// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var sl = /* @__PURE__ */ Symbol.for("pv"), ll = 0;
function l(e, t, n, o, r, i) {
  t || (t = {});
  var a, s, d = t;
  if ("ref" in d && typeof e != "function") for (s in d = {}, t) s == "ref" ? a = t[s] : d[s] = t[s];
  var c = { type: e, props: d, key: n, ref: a, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: sl, __v: --ll, __i: -1, __u: 0 };
  return (r || i) && (c.__source = r, c.__self = i), M.vnode && M.vnode(c), c;
}

// src/load.tsx
var ua = g(null), la = !1, gr = (e) => ua.value?.[e];
function ee({ part: e }) {
  let t = gr(e);
  return t ? l(t, {}) : null;
}
function ca() {
  C(() => {
    if (la || !(W.value ?? E.value)) return;
    la = !0;
    let e = "./gizmo.js";
    setTimeout(() => {
      import(e).then((t) => ua.value = t);
    }, 0);
  });
}

// src/units.ts
var io = 0.3048, fa = {
  level: { bare: 0.01, units: { "%": 0.01, x: 1, "×": 1 }, low: 0, high: 1e3, say: "a level such as 80 % or 450 lm" },
  flux: { bare: 1, units: { lm: 1, klm: 1e3 }, low: 0, high: 1e9, say: "a flux such as 450 lm" },
  kelvin: { bare: 1, units: { k: 1 }, low: 1e3, high: 25e3, say: "a colour temperature such as 2700 K" },
  angle: { bare: 1, units: { "°": 1, deg: 1, rad: 180 / Math.PI }, low: -36e3, high: 36e3, say: "an angle such as 30°" },
  length: {
    bare: 1,
    units: { m: 1, cm: 0.01, mm: 1e-3, km: 1e3, ft: io, "'": io, in: io / 12, '"': io / 12 },
    low: -1e6,
    high: 1e6,
    say: `a length such as 2.4 m, 75 cm or 8'2"`
  },
  lux: { bare: 1, units: { lx: 1, klx: 1e3, fc: 10.7639 }, low: 0, high: 1e9, say: "an illuminance such as 500 lx" },
  share: { bare: 1, units: { "%": 0.01 }, low: 0, high: 1, say: "a share from 0 to 1 or 0 to 100 %" },
  number: { bare: 1, units: {}, low: -1e9, high: 1e9, say: "a number" },
  ev: { bare: 1, units: { ev: 1, stop: 1, stops: 1 }, low: -30, high: 30, say: "an exposure such as 8.3" },
  seconds: { bare: 1, units: { s: 1, ms: 1e-3, min: 60 }, low: 0, high: 3600, say: "a time such as 2 s" }
}, ul = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;
function br(e) {
  let t = ul.exec(e);
  if (!t) return null;
  let [n, o] = t[0].split("/").map(Number);
  return o === 0 ? null : { value: o === void 0 ? n : n / o, rest: e.slice(t[0].length).trimStart() };
}
function pa(e, t, n) {
  let o = e.trim(), r = 0, i = !0;
  for (; o; ) {
    let a = 1, s = /^[+-]\s*/.exec(o);
    s && !i && (a = o[0] === "-" ? -1 : 1, o = o.slice(s[0].length));
    let d = br(o);
    if (!d) return null;
    let c = /^[a-zµ°%'"×]+/i.exec(d.rest)?.[0] ?? "", u = c === "" ? n : t.units[c.toLowerCase()];
    if (u === void 0) return null;
    r += a * d.value * u, o = d.rest.slice(c.length).trim(), i = !1;
  }
  return i ? null : r;
}
function da(e, t, n) {
  let o = fa[t], r = e.trim().replace(/,(?=\d)/g, ".").replace(/[\u2009\u202f\u00a0]/g, "").replace(/−/g, "-"), i = { why: `“${e.trim()}” is not ${o.say}` }, a = (w) => ({
    apply: (x) => Math.min(o.high, Math.max(o.low, w(x)))
  });
  if (!r) return { why: `Type ${o.say}` };
  let s = r.toLowerCase();
  if (t === "level" && s === "full") return a(() => 1);
  if (t === "level" && (s === "out" || s === "off")) return a(() => 0);
  let d = /^(.*?)\s*(?:stops?|ev)$/i.exec(r);
  if (d && t !== "ev") {
    let w = br(d[1].trim());
    return !w || w.rest || !["level", "flux", "lux", "number"].includes(t) ? i : a((x) => x * 2 ** w.value);
  }
  let c = /^([*/×÷])\s*(.+)$/.exec(r);
  if (c) {
    let w = br(c[2]);
    if (!w) return i;
    let x = w.rest === "%" ? 0.01 : w.rest === "" ? 1 : NaN, _ = w.value * x;
    return !Number.isFinite(_) || _ === 0 && /[/÷]/.test(c[1]) ? i : a((b) => /[/÷]/.test(c[1]) ? b / _ : b * _);
  }
  let p = t === "length" || t === "angle" || t === "ev" || t === "number" ? /^([+-])=\s*(.+)$/.exec(r) : /^([+-])=?\s*(.+)$/.exec(r), m = p ? p[2] : r, f = pa(m, o, o.bare);
  if (f === null && t === "level" && n) {
    let w = pa(m, { ...fa.flux }, NaN);
    f = w === null || Number.isNaN(w) ? null : w / n;
  }
  if (f === null || !Number.isFinite(f)) return i;
  let y = f;
  return p ? a((w) => p[1] === "-" ? w - y : w + y) : y < o.low || y > o.high ? { why: `${e.trim()} is out of range: ${o.say}` } : a(() => y);
}
function B(e, t = 0) {
  if (!Number.isFinite(e)) return "–";
  let [n, o] = Math.abs(e).toFixed(t).split("."), r = n.length > 4 ? n.replace(/\B(?=(\d{3})+$)/g, " ") : n;
  return (e < 0 && Number(Math.abs(e).toFixed(t)) !== 0 ? "−" : "") + r + (o ? `.${o}` : "");
}
function Qe(e) {
  let t = Math.abs(e);
  return B(e, t >= 99.95 || t === 0 ? 0 : t >= 9.995 ? 1 : t >= 0.9995 ? 2 : 3);
}
function Ie(e) {
  let t = e * 100;
  return B(t, t >= 9.95 || t === 0 ? 0 : t >= 0.95 ? 1 : 2);
}
function vn(e, t) {
  switch (t) {
    case "level":
      return `${Ie(e)} %`;
    case "flux":
      return `${Qe(e)} lm`;
    case "kelvin":
      return `${B(e)} K`;
    case "angle":
      return `${B(e, 1)}°`;
    case "length":
      return `${B(e, 2)} m`;
    case "lux":
      return `${Qe(e)} lx`;
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
  let n = At.value === "fc", o = n ? e / 10.7639 : e;
  return Qe(o) + (t ? n ? " fc" : " lx" : "");
}

// src/field.tsx
function gn(e) {
  let t = ot(null), n = ot(null), o = te(null), r = te(null), i = t.value ?? e.text ?? (e.value === null ? "mixed" : vn(e.value, e.quantity));
  Se(() => {
    !e.open || !o.current || (t.value = e.open, o.current.focus(), o.current.setSelectionRange(e.open.length, e.open.length), e.opened?.());
  }, [e.open]);
  let a = () => {
    if (t.value === null) return;
    let p = da(t.value, e.quantity, e.flux);
    if ("why" in p) {
      n.value = p.why;
      return;
    }
    t.value = null, n.value = null, e.set(p.apply);
  }, s = (p) => {
    if (p.key === "Enter")
      p.preventDefault(), a(), t.value === null && o.current?.select();
    else if (p.key === "Escape")
      p.stopPropagation(), t.value === null && o.current?.blur(), t.value = null, n.value = null;
    else if ((p.key === "ArrowUp" || p.key === "ArrowDown") && e.step && t.value === null) {
      p.preventDefault();
      let m = (p.key === "ArrowUp" ? 1 : -1) * e.step * (p.shiftKey ? 10 : p.ctrlKey ? 0.1 : 1);
      e.set((f) => f + m);
    }
  }, d = (p) => {
    !e.scrub || e.disabled || p.button !== 0 || document.activeElement === o.current || (r.current = { x: p.clientX, last: p.clientX, moved: !1 }, o.current?.setPointerCapture(p.pointerId), p.preventDefault());
  }, c = (p) => {
    let m = r.current;
    !m || !e.scrub || !m.moved && Math.abs(p.clientX - m.x) < 4 || (m.moved || e.scrub.begin(), m.moved = !0, e.scrub.on((p.clientX - m.last) * (e.step ?? 1) * (p.shiftKey ? 0.1 : p.altKey ? 10 : 1)), m.last = p.clientX);
  }, u = (p) => {
    let m = r.current;
    r.current = null, m && (m.moved ? p.type === "pointercancel" ? e.scrub?.cancel() : e.scrub?.end() : (o.current?.focus(), o.current?.select()));
  };
  return l("span", { class: `field ${n.value ? "wrong" : ""} ${e.scrub ? "scrubs" : ""}`, children: [
    l(
      "input",
      {
        ref: o,
        id: e.id,
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
        onInput: (p) => {
          t.value = p.currentTarget.value, n.value = null;
        },
        onFocus: (p) => t.value === null && p.currentTarget.select(),
        onBlur: () => {
          a(), n.value && (t.value = null, setTimeout(() => n.value = null, 4e3));
        },
        onKeyDown: s,
        onPointerDown: d,
        onPointerMove: c,
        onPointerUp: u,
        onPointerCancel: u
      }
    ),
    n.value && l("span", { class: "why", role: "alert", id: `${e.id ?? e.label}-why`.replace(/\s/g, "-"), children: n.value })
  ] });
}

// src/icon.tsx
function G({ name: e }) {
  return l("svg", { class: "sign", "aria-hidden": "true", width: "16", height: "16", children: l("use", { href: `icons.svg#${e}` }) });
}

// src/menu.tsx
function qt({ id: e, label: t, title: n, children: o }) {
  let r = (a) => {
    let s = document.getElementById(e), d = a.getBoundingClientRect();
    s?.style.setProperty("left", `${Math.max(8, Math.min(d.left, innerWidth - 296))}px`), s?.style.setProperty("top", `${d.bottom + 4}px`);
  };
  return l(X, { children: [
    l("button", { ...{ popovertarget: e }, title: n, "aria-label": n, "aria-haspopup": "true", onPointerDown: (a) => r(a.currentTarget), onFocus: (a) => r(a.currentTarget), children: t }),
    l("div", { id: e, popover: "auto", class: "menu", children: o })
  ] });
}
function _r({ id: e, label: t }) {
  let n = vr(e), o = aa(e);
  return l(
    "button",
    {
      class: "item",
      "aria-disabled": n !== null,
      title: n ?? void 0,
      onClick: (r) => {
        r.currentTarget.closest("[popover]")?.hidePopover(), oe(e);
      },
      children: [
        l("span", { children: t ?? o?.label }),
        l("kbd", { children: o?.keys })
      ]
    }
  );
}

// src/bar.tsx
var ma = {
  clean: "nothing changed",
  saved: "saved",
  waiting: "saving…",
  failed: "not saved"
};
function ha() {
  let e = at.value, t = rt.value.undo, n = rt.value.redo, o = it.value, r = e.metered;
  return l("header", { class: "bar", children: [
    l(qt, { id: "page-menu", label: l(G, { name: "menu" }), title: "Page", children: l(ee, { part: "PageItems" }) }),
    l("h1", { title: o.file || J.value?.file, children: [
      J.value?.name ?? "Lampyris",
      l("i", { class: `dot ${o.state}`, role: "img", "aria-label": ma[o.state], title: `${ma[o.state]}${o.file ? `: ${o.file}` : ""}` })
    ] }),
    l("span", { class: "group", children: [
      l("button", { class: "icon", "aria-label": t ? `Undo: ${t}` : "Undo", title: t ? `Undo: ${t} (Ctrl+Z)` : "Nothing to undo", "aria-disabled": t === null, onClick: () => oe("undo"), children: l(G, { name: "undo" }) }),
      l("button", { class: "icon", "aria-label": n ? `Redo: ${n}` : "Redo", title: n ? `Redo: ${n} (Ctrl+Shift+Z)` : "Nothing to redo", "aria-disabled": n === null, onClick: () => oe("redo"), children: l(G, { name: "redo" }) })
    ] }),
    l(qt, { id: "view-menu", label: l(X, { children: [
      "View ",
      l(G, { name: "down" })
    ] }), title: "View", children: l(ee, { part: "ViewItems" }) }),
    l("span", { class: "group wide", children: [
      l("button", { "aria-pressed": !1, onClick: () => oe("preset-plan"), title: "Plan (Shift+1)", children: "Plan" }),
      l("button", { onClick: () => oe("inside"), title: "Inside (Shift+0)", children: "Inside" })
    ] }),
    l("span", { class: "gap" }),
    l(qt, { id: "seeing-menu", label: l(X, { children: [
      "Picture ",
      l(G, { name: "down" })
    ] }), title: "Picture: tone, white, figures", children: l(ee, { part: "SeeingItems" }) }),
    l("button", { "aria-pressed": e.false_color !== null, onClick: mr, title: "False colour (B)", children: "False colour" }),
    l("button", { "aria-pressed": de.value === "wipe", "aria-disabled": mn.value === null, onClick: () => oe("wipe"), title: "Wipe between before and now (C); hold \\ to see before", children: "Compare" }),
    l("span", { class: "group exposure", role: "group", "aria-label": "Exposure", children: [
      l("button", { class: "icon", "aria-label": "Darker", title: "Darker by ⅓ (,)", onClick: () => ro(1), children: l(G, { name: "minus" }) }),
      l("label", { children: [
        l("span", { "aria-hidden": "true", children: "EV" }),
        l(gn, { label: "Exposure value", quantity: "ev", value: e.ev ?? 0, step: 1 / 3, set: (i) => Tt({ ev: i(e.ev ?? 0) }) })
      ] }),
      l("button", { class: "icon", "aria-label": "Brighter", title: "Brighter by ⅓ (.)", onClick: () => ro(-1), children: l(G, { name: "plus" }) }),
      l("button", { class: "icon", "aria-label": "Meter once", title: `${r ? "As metered" : "Meter once"} (/); it stays locked`, onClick: () => D({ do: "expose" }), children: l(G, { name: r ? "lock" : "meter" }) })
    ] }),
    l(
      "button",
      {
        class: "icon look-lock",
        "aria-pressed": $e.value,
        "aria-label": "Look-only lock",
        title: "Look-only lock: no finger changes anything",
        onClick: () => $e.value = !$e.value,
        children: l(G, { name: $e.value ? "lock" : "unlock" })
      }
    ),
    fe.value === "edit" && l("button", { class: "wide", onClick: () => pt.value = "share", children: "Share" }),
    l("button", { class: "icon", "aria-label": "All keys", title: "All keys (?)", onClick: () => pt.value = "help", children: l(G, { name: "help" }) }),
    l("button", { class: "icon", "aria-label": "Command palette", title: "Command palette (Ctrl+K)", onClick: () => pt.value = "palette", children: l(G, { name: "search" }) }),
    l(
      "button",
      {
        class: "icon narrow",
        "aria-label": Ve.value === "inspector" ? "Lamps" : "Inspector",
        title: Ve.value === "inspector" ? "Lamps" : "Inspector",
        onClick: () => Ve.value = Ve.value === "inspector" ? "lamps" : "inspector",
        children: l(G, { name: Ve.value === "inspector" ? "lamps" : "sliders" })
      }
    )
  ] });
}

// src/highlight.ts
function ao(e) {
  we.value = e, D({ do: "solo", lamps: e });
}
function yr(e) {
  let t = we.peek(), n = e.every((o) => t.includes(o));
  ao(n ? t.filter((o) => !e.includes(o)) : [...t, ...e.filter((o) => !t.includes(o))]);
}
var cl = () => yr(le.peek()), wr = () => ao([]), bn = null;
function so(e) {
  e && bn === null && le.peek().length ? (bn = we.peek(), ao(le.peek())) : !e && bn !== null && (ao(bn), bn = null);
}

// src/lights.ts
var Je = g(null), kr = () => {
}, ga = () => {
};
function lo(e, t, n) {
  uo(), Je.value = { x: e, y: t, hit: n, lux: n.lux, lamps: [], done: !1 }, va(n);
  let o = !0, r = 0;
  ga = C(() => {
    for (let [, i] of k.all()) Re(i);
    if (o) {
      o = !1;
      return;
    }
    clearTimeout(r), r = window.setTimeout(() => {
      let i = ie(() => Je.value);
      i && va(i.hit);
    }, 250);
  });
}
function va(e) {
  kr(), kr = xe("light", { point: e.point, normal: e.normal }, (t) => {
    let n = Je.peek();
    n && (Je.value = {
      ...n,
      lux: t.lux ?? n.lux,
      lamps: t.lamps ?? n.lamps,
      done: t.done !== !1
    });
  });
}
function uo() {
  kr(), ga(), Je.value = null;
}

// src/keys.ts
var Sa = g("W A S D"), xr = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyA: [0, -1, 0],
  KeyD: [0, 1, 0],
  KeyQ: [0, 0, -1],
  KeyE: [0, 0, 1]
}, fl = 1.8, jt = /* @__PURE__ */ new Set(), co = !1, fo = 1, Sr = !1, Mr = 0;
function Ma(e) {
  let t = Math.min(0.1, Math.max(0, (e - Mr) / 1e3));
  if (Mr = e, !jt.size) {
    Sr = !1;
    return;
  }
  let [n, o, r] = [0, 0, 0];
  for (let s of jt) {
    let [d, c, u] = xr[s];
    n += d, o += c, r += u;
  }
  let i = Math.max(1, De(...Ht()) / 12), a = fl * t * fo * Math.min(i, 6);
  (n || o || r) && oa(n * a, o * a, r * a), requestAnimationFrame(Ma);
}
function _n(e) {
  jt.add(e), !Sr && (Sr = !0, Mr = performance.now(), requestAnimationFrame(Ma));
}
var pl = (e) => e instanceof HTMLElement && (e.isContentEditable || e.matches("input, textarea, select") && !e.matches("[type=range], [type=checkbox], [type=radio]"));
function ba() {
  let e = document.activeElement;
  return e === null || e === document.body || e.id === "view";
}
var dl = {
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
}, _a = {
  b: "quantity",
  o: "park",
  i: "unsolo",
  l: "from-lamp",
  g: "grid",
  t: "aim-here"
}, ya = { Comma: "darker", Period: "brighter", Slash: "expose" }, wa = {
  Digit1: "preset-plan",
  Digit2: "preset-ceiling",
  Digit3: "preset-north",
  Digit4: "preset-east",
  Digit5: "preset-south",
  Digit6: "preset-west",
  Digit0: "inside"
};
function ml(e) {
  let t = e.key.toLowerCase();
  return t === "z" ? e.shiftKey ? "redo" : "undo" : t === "y" ? "redo" : t === "k" ? "palette" : t === "s" ? e.shiftKey ? "picture" : "save" : t === "d" ? "duplicate" : t === "a" ? "all-lamps" : t === "enter" ? "look-store" : null;
}
function hl() {
  z.peek() ? z.value = null : Je.peek() ? uo() : de.peek() ? de.value = null : E.peek() ? Yn() : document.activeElement?.id === "view" && document.querySelector('.bar button, .bar [tabindex="0"]')?.focus();
}
function ka(e) {
  let [t, n] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
  return !t && !n ? !1 : (e.ctrlKey || ne()?.height ? Ft(-t * 24, n * 24, 3) : e.shiftKey ? eo(Ot(), -t * 0.05, n * 0.05) : Zn(-t * 0.06, n * 0.06), !0);
}
function xa(e) {
  let t = ne(), n = ft();
  !t || !n || (t.height ? Q(Bn(t, n, n.width / 2, n.height / 2, e)) : Q(Wn(t, t.target, e, 0.3, !0)));
}
function vl(e) {
  if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
  let t = e.ctrlKey || e.metaKey;
  if (e.key === "Escape") return hl();
  if (pl(e.target)) {
    t && e.key.toLowerCase() === "k" && Oe(e, "palette");
    return;
  }
  if (t && !e.altKey) {
    if (ba() && ka(e)) return e.preventDefault();
    let i = ml(e);
    i && Oe(e, i);
    return;
  }
  if (e.altKey) {
    let i = /^Digit(\d)$/.exec(e.code)?.[1];
    if (e.key === "ArrowLeft") return Oe(e, "back");
    if (e.key === "ArrowRight") return Oe(e, "forth");
    if (i === "0") return Oe(e, "store-view");
    if (i) {
      e.preventDefault();
      let a = kt.all()[Number(i) - 1];
      a && Q(a[1], a[1].name ?? "view");
      return;
    }
    if (e.code === "KeyH" && Oe(e, "unhide"), !(e.code in xr)) return;
  }
  let n = ba();
  if (n && ka(e)) return e.preventDefault();
  if (n && e.code in xr)
    return fo = e.shiftKey ? 4 : e.altKey ? 0.25 : 1, _n(e.code), e.preventDefault();
  if (n && (e.key === "+" || e.key === "=")) return xa(0.85);
  if (n && (e.key === "-" || e.key === "_")) return xa(1 / 0.85);
  if (!Zo.peek()) return;
  if (e.shiftKey && wa[e.code]) return Oe(e, wa[e.code]);
  if (co && /^\d$/.test(e.key)) {
    e.preventDefault(), co = !1;
    let i = xt.ids.peek()[Number(e.key) - 1];
    i !== void 0 && oo({ do: "look", id: i, what: "recall", seconds: tr.peek() });
    return;
  }
  if (co = e.key.toLowerCase() === "j", co) return ae("Recall a look: now its digit.");
  if (!e.shiftKey && /^\d$/.test(e.key) && le.peek().length) {
    e.preventDefault(), dr.value = e.key;
    return;
  }
  if (!e.shiftKey && e.key !== "?" && ya[e.code]) return Oe(e, ya[e.code]);
  if (e.key === "\\") return void (e.repeat || hn(!0));
  let o = e.key.toLowerCase();
  if (o === "l" && !e.shiftKey) return void (e.repeat || oe("highlight"));
  if (o === "p" && e.shiftKey) return gl();
  let r = e.shiftKey && _a[o] ? _a[o] : dl[o];
  r && !(e.target instanceof HTMLButtonElement && o === "enter") && Oe(e, r);
}
function gl() {
  let [e, t] = be.peek(), n = Dt(e / 2, t / 2);
  n && xe("point", n, (o) => o.hit && lo(e / 2, t / 2, o));
}
function Oe(e, t) {
  e.preventDefault(), oe(t);
}
function bl(e) {
  jt.delete(e.code), e.key === "\\" && hn(!1), e.key.toLowerCase() === "l" && so(!1), e.key === "Shift" && (fo = 1);
}
function Ca() {
  addEventListener("keydown", vl), addEventListener("keyup", bl), addEventListener("blur", () => {
    jt.clear(), so(!1), hn(!1);
  }), navigator.keyboard?.getLayoutMap().then((t) => {
    Sa.value = ["KeyW", "KeyA", "KeyS", "KeyD"].map((n) => (t.get(n) ?? n.slice(3)).toUpperCase()).join(" ");
  }).catch(() => {
  });
}
function _l(e, t) {
  for (let n of ["KeyW", "KeyS", "KeyA", "KeyD"]) jt.delete(n);
  fo = Math.min(1, Math.hypot(e, t)), e > 0.2 && _n("KeyW"), e < -0.2 && _n("KeyS"), t < -0.2 && _n("KeyA"), t > 0.2 && _n("KeyD");
}

// src/levels.ts
var Cr = (e) => Math.min(1, Xn.value === "square" ? Math.sqrt(Math.max(e, 0)) : e), Er = (e) => {
  let t = Xn.peek() === "square" ? e * e : e;
  return Math.round(t * 1e3) / 1e3;
}, yl = (e) => (e.kind === "lamp" ? k.get(e.id) : K.get(e.id))?.level ?? 0, po = (e) => (e.kind === "lamp" ? k.get(e.id) : K.get(e.id))?.name ?? "";
function Tr(e) {
  let t = le.peek();
  return e.kind === "lamp" && E.peek()?.kind === "lamp" && t.length > 1 && t.includes(e.id) ? t : [e.id];
}
function Ea(e, t, n) {
  if (e.kind === "group") return { groups: { [e.id]: { level: t } } };
  let o = n.get(e.id) ?? 0, r = {};
  for (let [i, a] of n) {
    let s = i === e.id ? t : o > 0 ? Math.min(10, a * (t / o)) : t;
    r[i] = { level: Math.round(s * 1e3) / 1e3 };
  }
  return { lamps: r };
}
var yn = class {
  constructor(t) {
    this.strip = t;
    this.was = this.now = yl(t), this.from = t.kind === "lamp" ? new Map(Tr(t).map((n) => [n, k.get(n)?.level ?? 0])) : /* @__PURE__ */ new Map(), this.gesture = new We(`${po(t)} level`);
  }
  strip;
  gesture;
  from;
  was;
  now;
  to(t) {
    this.now = t, this.gesture.set(Ea(this.strip, t, this.from));
  }
  end() {
    let t = this.from.size > 1 ? Qn([...this.from.keys()]) : po(this.strip);
    this.gesture.end(`${t} ${Ie(this.was)} → ${Ie(this.now)} %`);
  }
  cancel() {
    this.gesture.cancel();
  }
};
function mo(e, t) {
  let n = new Map(Tr(e).map((o) => [o, k.get(o)?.level ?? 0]));
  Uo(`level ${e.kind} ${e.id}`, `${po(e)} level`, Ea(e, t, n));
}
function Pr(e, t) {
  if (!e.length) return;
  let n = Object.fromEntries(e.map((r) => {
    let i = k.get(r);
    return [r, { level: t(i?.level ?? 0, i?.flux ?? 1) }];
  })), o = e.length === 1 ? ` ${Ie(k.get(e[0])?.level ?? 0)} → ${Ie(n[e[0]].level)} %` : " level";
  Te(`${Qn(e)}${o}`, { lamps: n });
}
function $r(e, t) {
  let n = t(K.get(e)?.level ?? 0);
  Te(`${K.get(e)?.name ?? "Group"} ${Ie(n)} %`, { groups: { [e]: { level: n } } });
}
function Lr(e, t) {
  let n = `${po(e)} ${t ? "on" : "off"}`;
  e.kind === "group" ? Te(n, { groups: { [e.id]: { on: t } } }) : Te(n, { lamps: Object.fromEntries(Tr(e).map((o) => [o, { on: t }])) });
}

// src/swatch.ts
var wl = (e) => e <= 31308e-7 ? 12.92 * e : 1.055 * e ** 0.4166666666666667 - 0.055, kl = (e) => e <= 0.04045 ? e / 12.92 : ((e + 0.055) / 1.055) ** 2.4, xl = (e) => Math.round(255 * wl(Math.max(0, Math.min(1, e))));
function Vr(e) {
  let t = Math.max(...e, 1e-6);
  return Ta(e.map((n) => n / t));
}
function Ta(e) {
  return `#${e.map((t) => xl(t).toString(16).padStart(2, "0")).join("")}`;
}
function Sl(e) {
  let t = (n) => kl(parseInt(e.slice(1 + 2 * n, 3 + 2 * n), 16) / 255);
  return [t(0), t(1), t(2)];
}
var Ml = (e) => 1e6 / e;

// src/range.tsx
var Pa = -1e9;
addEventListener("scroll", () => Pa = performance.now(), { capture: !0, passive: !0 });
var Ut = (e) => Math.max(0, Math.min(1, e));
function Ir(e) {
  let t = te(null), n = te(null), o = e.notch ?? 0.01, r = (c) => {
    if (c.button !== 0 || e.disabled) return;
    let u = c.currentTarget.getBoundingClientRect(), p = e.vertical ? (u.bottom - c.clientY - 8) / (u.height - 16) : (c.clientX - u.left - 6) / (u.width - 12), m = c.pointerType !== "touch" && !c.shiftKey;
    n.current = { id: c.pointerId, x: c.clientX, y: c.clientY, at: m ? Ut(p) : e.value }, t.current?.setPointerCapture(c.pointerId), t.current?.focus(), e.begin?.(), m && e.on(Ut(p));
  }, i = (c) => {
    let u = n.current;
    if (!u || u.id !== c.pointerId) return;
    let p = c.currentTarget.getBoundingClientRect(), m = e.vertical ? (u.y - c.clientY) / (p.height - 16) : (c.clientX - u.x) / (p.width - 12);
    u.x = c.clientX, u.y = c.clientY, u.at += m * (c.shiftKey ? 0.1 : 1), e.on(Ut(u.at));
  }, a = (c) => {
    n.current?.id === c.pointerId && (n.current = null, c.type === "pointercancel" ? e.cancel?.() : e.end?.());
  }, s = (c) => {
    if (c.key === "Escape" && n.current) {
      n.current = null, e.cancel?.(), c.stopPropagation();
      return;
    }
    let u = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[c.key], p = null;
    u && (p = Ut(e.value + u * o * (c.shiftKey ? 10 : 1))), c.key === "Home" && (p = 0), c.key === "End" && (p = 1), !(p === null || c.altKey || c.ctrlKey || c.metaKey) && (c.preventDefault(), c.stopPropagation(), e.on(p));
  }, d = (c) => {
    if (performance.now() - Pa < 400 || c.ctrlKey) return;
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
      onWheel: d,
      onDblClick: () => e.reset?.(),
      onInput: (c) => {
        n.current ? c.currentTarget.value = String(e.value) : e.on(Number(c.currentTarget.value));
      }
    }
  );
}

// src/faderrow.tsx
function $a(e) {
  let t = e.color;
  return t.mode === "kelvin" ? `${B(t.kelvin)} K` : t.mode === "rgb" ? "RGB" : t.mode === "xy" ? "x y" : "file";
}
var Ar = (e) => e.free ? "re-mix: level and colour cost no ray" : "re-trace: its light is traced anew";
function La({ row: e, index: t, count: n }) {
  let o = te(null), r = { kind: e.kind, id: e.id }, i = e.kind === "lamp" ? k.get(e.id) : void 0, a = e.kind === "group" ? K.get(e.id) : void 0, s = i ?? a;
  if (!s) return null;
  let d = a?.lamps ?? [e.id], c = i ? i.flux : d.reduce((_, b) => _ + (k.get(b)?.flux ?? 0) * (k.get(b)?.level ?? 0), 0), u = i ? i.flux * Re(i) : d.reduce((_, b) => _ + (k.get(b)?.flux ?? 0) * Re(k.get(b)), 0), p = E.value?.kind === e.kind && E.value.ids.includes(e.id), m = d.length > 0 && d.every((_) => we.value.includes(_)), f = we.value.length > 0 && !d.some((_) => we.value.includes(_)), y = pe.value?.kind === e.kind && pe.value.id === e.id, w = `${p ? "selected" : ""} ${s.on && !i?.parked ? "" : "off"} ${f ? "muted" : ""} ${y ? "under" : ""}`, x = {
    begin: () => o.current = new yn(r),
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
      class: `fader-row depth-${e.depth} ${e.kind} ${w}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => pe.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => pe.value = null,
      children: [
        l("button", { class: "icon power", "aria-pressed": s.on, "aria-label": `${s.name} on`, title: s.on ? "On (O)" : "Off (O)", onClick: () => Lr(r, !s.on), children: l(G, { name: "power" }) }),
        l("div", { class: "top", children: [
          a && l("button", { class: "icon fold", "aria-expanded": !mt.value.has(e.id), "aria-label": `Members of ${s.name}`, onClick: () => Va(e.id), children: l(G, { name: mt.value.has(e.id) ? "right" : "down" }) }),
          l("button", { class: "row-name", "aria-pressed": p, title: i ? `${i.name}: ${Ar(i)}` : s.name, onClick: (_) => Rr(_, e.kind, e.id), children: [
            l("span", { children: s.name }),
            a && l("small", { children: d.length }),
            i?.parked && l("small", { children: "parked" }),
            i && !i.free && l("small", { class: "traced", title: Ar(i), children: [
              "↻",
              l("span", { class: "spoken", children: "re-trace" })
            ] })
          ] }),
          i && l("span", { class: "tint", children: [
            l("i", { class: "swatch", style: { background: Vr(i.swatch) } }),
            $a(i)
          ] }),
          l("button", { class: "icon solo", "aria-pressed": m, "aria-label": `Solo ${s.name}`, title: "Solo (I)", onClick: () => yr(d), children: l(G, { name: "solo" }) })
        ] }),
        l("div", { class: "bottom", children: [
          l(
            Ir,
            {
              label: `${s.name} level`,
              class: "level",
              value: Cr(s.level),
              text: `${Ie(s.level)} %, ${Qe(u)} lumen`,
              notch: 0.01,
              on: (_) => {
                let b = Er(_);
                o.current ? o.current.to(b) : mo(r, b);
              },
              reset: () => mo(r, 1),
              ...x
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
              set: (_) => i ? Pr(p && le.peek().length > 1 ? le.peek() : [e.id], _) : $r(e.id, _)
            }
          ),
          l("span", { class: "lumens", children: vn(u, "flux") })
        ] })
      ]
    }
  );
}

// src/virtual.tsx
var Ia = 4;
function Hr({ count: e, height: t, row: n, label: o, show: r, role: i = "list" }) {
  let a = te(null), s = ot(0), d = ot(600);
  Se(() => {
    let p = a.current, m = new ResizeObserver(() => d.value = p.clientHeight);
    return m.observe(p), () => m.disconnect();
  }, []), Se(() => {
    let p = a.current;
    if (!p || r === void 0 || r < 0) return;
    let m = r * t;
    (m < p.scrollTop || m + t > p.scrollTop + p.clientHeight) && (p.scrollTop = Math.max(0, m - p.clientHeight / 2));
  }, [r, t]);
  let c = Math.max(0, Math.floor(s.value / t) - Ia), u = Math.min(e, Math.ceil((s.value + d.value) / t) + Ia);
  return l("div", { class: "virtual", ref: a, tabIndex: e ? void 0 : -1, onScroll: (p) => s.value = p.currentTarget.scrollTop, children: l("div", { class: "all", role: i, "aria-label": o, style: { height: `${e * t}px` }, children: l("div", { class: "rows", role: "presentation", style: { transform: `translateY(${c * t}px)` }, children: Array.from({ length: Math.max(0, u - c) }, (p, m) => n(c + m)) }) }) });
}

// src/lamps.tsx
var ho = g(""), mt = g(/* @__PURE__ */ new Set()), vo = g("group"), Ra = q(() => {
  let e = ho.value.trim().toLowerCase(), t = (r) => {
    let i = k.get(r);
    return i ? !e || `${i.name} ${i.kind} ${K.get(i.group)?.name ?? ""}`.toLowerCase().includes(e) : !1;
  };
  if (vo.value !== "group" && It.value === "sheet") {
    let r = vo.value, i = k.all().filter(([a]) => t(a));
    return i.sort(([, a], [, s]) => r === "name" ? a.name.localeCompare(s.name, "en", { numeric: !0 }) : s[r] - a[r]), i.map(([a]) => ({ kind: "lamp", id: a, depth: 0 }));
  }
  let n = [], o = /* @__PURE__ */ new Set();
  for (let [r, i] of K.all()) {
    i.lamps.forEach((s) => o.add(s));
    let a = i.lamps.filter(t);
    if (a.length) {
      if (i.lamps.length === 1) {
        n.push({ kind: "lamp", id: a[0], depth: 0 });
        continue;
      }
      n.push({ kind: "group", id: r, depth: 0 }), (!mt.value.has(r) || e) && a.forEach((s) => n.push({ kind: "lamp", id: s, depth: 1 }));
    }
  }
  for (let r of k.ids.value) !o.has(r) && t(r) && n.push({ kind: "lamp", id: r, depth: 0 });
  return n;
}), Aa = !1;
K.ids.subscribe((e) => {
  Aa || !e.length || (Aa = !0, k.ids.peek().length > 40 && (mt.value = new Set(e.filter((t) => (K.get(t)?.lamps.length ?? 0) > 1))));
});
function Va(e) {
  let t = new Set(mt.peek());
  t.delete(e) || t.add(e), mt.value = t;
}
function Rr(e, t, n) {
  e.shiftKey ? Qi(t, Ra.peek().filter((o) => o.kind === t).map((o) => o.id), n) : Xe(t, n, e.ctrlKey || e.metaKey ? "toggle" : "only");
}
function Cl(e) {
  let t = { ArrowDown: 1, ArrowUp: -1 }[e.key], n = e.target;
  if (!t || !n.matches(".row-name")) return;
  e.preventDefault();
  let o = [...e.currentTarget.querySelectorAll(".row-name")];
  o[o.indexOf(n) + t]?.focus();
}
var El = ["add-spot", "add-point", "add-disc", "add-sphere"];
function Ha() {
  let e = Ra.value, t = E.value?.ids[E.value.ids.length - 1], n = e.findIndex((i) => i.kind === E.value?.kind && i.id === t), o = matchMedia("(pointer: coarse)").matches, r = It.value === "sheet";
  return l("section", { class: "panel lamps", "aria-label": "Lamps", onKeyDown: Cl, children: [
    l("header", { class: "panel-head", children: [
      l("h2", { children: [
        "Lamps ",
        l("small", { children: B(k.ids.value.length) })
      ] }),
      l("span", { class: "gap" }),
      l("div", { class: "segments", role: "group", "aria-label": "Listing", children: [
        l("button", { "aria-pressed": !r, onClick: () => It.value = "faders", children: "Faders" }),
        l("button", { "aria-pressed": r, onClick: () => It.value = "sheet", children: "Sheet" })
      ] })
    ] }),
    l("div", { class: "panel-tools", children: [
      l("span", { class: "field filter", children: l(
        "input",
        {
          type: "text",
          "aria-label": "Filter lamps",
          placeholder: "Filter",
          value: ho.value,
          onInput: (i) => ho.value = i.currentTarget.value,
          onKeyDown: (i) => {
            i.key === "Escape" && (ho.value = "", i.stopPropagation());
          }
        }
      ) }),
      r && l("select", { "aria-label": "Order", value: vo.value, onChange: (i) => vo.value = i.currentTarget.value, children: [
        l("option", { value: "group", children: "by group" }),
        l("option", { value: "name", children: "by name" }),
        l("option", { value: "flux", children: "by flux" }),
        l("option", { value: "level", children: "by level" })
      ] }),
      l(qt, { id: "add-menu", label: "Add", title: "Add a lamp", children: [
        El.map((i) => l(_r, { id: i }, i)),
        l("button", { class: "item", "aria-disabled": "true", title: "Photometric files come with a later version", children: [
          l("span", { children: "IES or LDT file…" }),
          l("kbd", { children: "later" })
        ] })
      ] })
    ] }),
    le.value.length > 1 && l("p", { class: "several", children: [
      le.value.length,
      " selected; a fader moves them in proportion",
      l("button", { onClick: () => oe("none"), children: "None" })
    ] }),
    r && l(ee, { part: "SheetHead" }),
    l(
      Hr,
      {
        label: "Lamps and groups",
        count: e.length,
        height: r ? o ? 44 : 28 : o ? 84 : 54,
        show: n,
        row: (i) => {
          let a = e[i], s = r ? gr("SheetRow") : La;
          return s && l(s, { row: a, index: i, count: e.length }, `${a.kind}${a.id}`);
        }
      }
    ),
    !e.length && k.ids.value.length > 0 && l("p", { class: "quiet empty", children: "No lamp is called so." })
  ] });
}

// src/states.ts
var wn = g(null), Ze = g([]), kn = g(null), Dr = g(null), Kr = q(() => Ce.value?.stage ?? "loading"), Tl = q(() => {
  let e = Ce.value?.fps ?? 0;
  return Kr.value === "moving" && e > 6 && Vt.value < 0.4 * e && Vt.value < 5;
}), Wt = q(() => {
  switch (U.value) {
    case "entering":
      return "starting";
    case "open":
      break;
    default:
      return U.value;
  }
  return !J.value || !W.value ? "loading" : it.value.state === "failed" ? "unsaved" : wn.value !== null ? "broken" : kn.value !== null && !j.value.you ? "control-lost" : fe.value === "watch" || !j.value.you ? "watching" : k.ids.value.length === 0 ? "no-lamps" : Ci.value ? "all-off" : Tl.value ? "slow" : Kr.value === "loading" ? "first" : Kr.value;
});
ke("event", (e) => {
  switch (e.what) {
    case "reloaded": {
      wn.value = null, Ze.value = e.lost ?? [];
      let t = e.kept ?? 0;
      ae(`The scene was read again: ${t} edits kept${Ze.value.length ? `, ${Ze.value.length} no longer find what they changed` : ""}.`);
      break;
    }
    case "broken":
      wn.value = e.why ?? "The scene file cannot be read.";
      break;
    case "taken":
      kn.value = e.by ?? j.peek().name ?? "somebody else";
      break;
    case "loading":
      Dr.value = e;
      break;
  }
});
ke("refused", (e) => ae(e.why ?? "That could not be done.", "warn"));
C(() => {
  j.value.you && (kn.value = null);
});

// src/probe.ts
var go = g(null);
function bo(e, t, n) {
  let o = Dt(e, t);
  if (!o) return n(null);
  xe("point", o, (r) => n(r.hit ? r : null));
}
function Ka(e) {
  if (!e) return "";
  let t = [], n = k.get(e.lamp)?.name, o = he.get(e.thing)?.name, r = wt.get(e.material)?.name;
  if (n && t.push(n), o && o !== n && t.push(o), r && r !== o && t.push(r), e.lux && t.push(`${dt(e.lux[0])} ±${dt(e.lux[1], !1)}`), e.luminance) {
    let i = e.luminance[0] * (At.value === "fc" ? 0.2919 : 1);
    t.push(`${Qe(i)} ${At.value === "fc" ? "fL" : "cd/m²"}`);
  }
  return t.join(" · ");
}

// src/status.tsx
var Da = q(() => {
  W.value;
  let e = [];
  for (let t of se.sent.slice(-24)) {
    if (t.what !== "set" && t.what !== "camera") continue;
    let n = se.frames.find((o) => o.seq >= t.seq && o.painted);
    n && n.painted > t.at && e.push(n.painted - (t.input || t.at));
  }
  return e.sort((t, n) => t - n), e.length ? e[e.length >> 1] : null;
});
function Pl() {
  let e = Ce.value;
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
function Oa() {
  let e = Ce.value, t = W.value?.head, n = on.value.filter((r) => r.batches < r.of && !r.held).length, o = e?.stage === "refining" && e.good_in ? Math.max(0.02, 1 / (1 + e.good_in)) : e?.stage === "good" || e?.stage === "done" ? 1 : 0.02;
  return l("footer", { class: "status", "aria-label": "Status", children: [
    l("span", { class: `quality ${e?.stage ?? ""}`, children: [
      l("i", { class: "thin", "aria-hidden": "true", children: l("b", { style: { width: `${o * 100}%` } }) }),
      Pl()
    ] }),
    l("span", { children: [
      B(t?.batches ?? e?.batches ?? 0),
      " batches"
    ] }),
    l("span", { children: U.value === "open" ? `${B(Vt.value)} fps` : "no line" }),
    Da.value !== null && l("span", { title: "From the hand to the paint, median", children: [
      B(Da.value),
      " ms"
    ] }),
    t && l("span", { children: [
      t.width,
      " × ",
      t.height
    ] }),
    l("span", { class: "wide", children: [
      on.value.length,
      " layers",
      n ? `, ${n} tracing` : ""
    ] }),
    l("span", { class: "probe", "aria-live": "off", children: Ka(go.value) }),
    l("span", { class: "gap" }),
    l("span", { children: j.value.you ? "editing: you" : `editing: ${j.value.name ?? "somebody else"}` }),
    l("span", { class: "spoken", children: [
      jo.value ?? "",
      " ",
      Wt.value
    ] })
  ] });
}

// src/pointer.ts
var $l = 4, Fa = 35e-4, Ll = 0.15;
function Vl(e, t, n) {
  return e === "maya" && n.alt ? ["orbit", "pan", "dolly"][t] ?? "none" : e === "blender" && t === 1 ? n.shift ? "pan" : n.ctrl ? "dolly" : "orbit" : t === 1 ? n.shift ? "pan" : "orbit" : t === 2 ? "look" : t === 0 ? n.alt ? "orbit" : n.space ? "pan" : n.shift || n.ctrl ? "none" : "look" : "none";
}
function Na(e, t) {
  let n = /* @__PURE__ */ new Map(), o = Ot(), r = 3, i = !1, a = 0, s = 0, d = 0, c = null, u = (h) => {
    let v = e.getBoundingClientRect();
    return [h.clientX - v.left, h.clientY - v.top];
  }, p = (h, v, T) => {
    let P = Dt(h, v);
    P && xe("point", P, ($) => {
      let I = $;
      I.hit && T?.(I);
    });
  }, m = (h) => {
    let v = ft();
    return v ? Math.max(0.2, F(O(h, v.eye), v.forward)) : r;
  };
  function f(h) {
    if (h.target.closest("[data-handle]")) return;
    e.focus({ preventScroll: !0 });
    let [v, T] = u(h), P = h.pointerType === "touch", $ = { alt: h.altKey, shift: h.shiftKey, ctrl: h.ctrlKey || h.metaKey, space: i }, I = P ? "look" : Vl(Gn.peek(), h.button, $);
    I === "look" && ne()?.height && (I = "pan"), z.peek() === "marquee" && h.button === 0 && (I = "none"), n.set(h.pointerId, {
      id: h.pointerId,
      button: h.button,
      x: v,
      y: T,
      startX: v,
      startY: T,
      moved: !1,
      motion: I,
      touch: P,
      shift: h.shiftKey,
      ctrl: $.ctrl
    }), e.setPointerCapture(h.pointerId), clearTimeout(a), t.unhover(), (I === "orbit" || I === "pan" || I === "dolly") && (o = Ot(), r = m(o), p(v, T, (R) => {
      o = R.point, r = m(R.point);
    })), clearTimeout(s), P && n.size === 1 && (s = window.setTimeout(() => {
      let R = n.get(h.pointerId);
      R && !R.moved && n.size === 1 && (R.moved = !0, R.motion = "none", t.menu(R.x, R.y));
    }, 550)), n.size === 2 && (c = y()), h.button === 1 && h.preventDefault();
  }
  function y() {
    let [h, v] = [...n.values()];
    return { gap: Math.hypot(h.x - v.x, h.y - v.y), x: (h.x + v.x) / 2, y: (h.y + v.y) / 2 };
  }
  function w(h) {
    let v = n.get(h.pointerId), [T, P] = u(h);
    if (!v) {
      if (h.pointerType === "touch" || h.buttons) return;
      t.unhover(), clearTimeout(a), a = window.setTimeout(() => t.hover(T, P), 150);
      return;
    }
    let [$, I] = [T - v.x, P - v.y];
    if (!(!v.moved && Math.hypot(T - v.startX, P - v.startY) < $l)) {
      if (v.moved = !0, v.x = T, v.y = P, n.size === 2 && c) {
        let R = y();
        Ft(R.x - c.x, R.y - c.y, r), R.gap > 8 && c.gap > 8 && b(R.x, R.y, c.gap / R.gap, !1), c = R;
        return;
      }
      if (z.peek() === "marquee" && v.button === 0) {
        t.marquee([v.startX, v.startY], [T, P], !1);
        return;
      }
      switch (v.motion) {
        case "look": {
          let R = v.touch ? 1 : -1;
          Zn(R * $ * Fa, R * I * Fa);
          break;
        }
        case "orbit":
          eo(o, -$ * 6e-3, -I * 6e-3);
          break;
        case "pan":
          Ft($, I, r);
          break;
        case "dolly":
          b(v.startX, v.startY, Math.exp(I * 6e-3), !1);
          break;
        case "none":
          break;
      }
    }
  }
  function x(h) {
    let v = n.get(h.pointerId);
    if (n.delete(h.pointerId), clearTimeout(s), n.size < 2 && (c = null), !(!v || h.type === "pointercancel")) {
      if (v.moved) {
        z.peek() === "marquee" && t.marquee([v.startX, v.startY], [v.x, v.y], !0);
        return;
      }
      if (v.touch) {
        let T = performance.now(), P = T - d < 320;
        if (d = T, P) return t.double();
        if ($e.peek()) return;
      }
      if (v.button === 2) t.menu(v.x, v.y);
      else if (v.button === 0) {
        let T = v.shift ? "add" : v.ctrl ? "toggle" : "only";
        t.click(v.x, v.y, T);
      }
    }
  }
  let _ = null;
  function b(h, v, T, P) {
    let $ = ne(), I = ft();
    if (!$ || !I) return;
    if ($.height) return Q(Bn($, I, h, v, T));
    let R = performance.now();
    if (!_ || R - _.time > 500 || Math.hypot(h - _.x, v - _.y) > 6) {
      _ = { x: h, y: v, time: R, point: null };
      let vt = _;
      p(h, v, (jr) => {
        vt.point = jr.point, r = m(jr.point);
      });
    }
    _.time = R;
    let [Qa, Ja] = [h - I.width / 2, I.height / 2 - v], Za = Math.min(r, De($.eye, Ot()) + 1), _o = (vt) => $.eye[vt] + (I.forward[vt] + I.side[vt] * Qa * I.pixel + I.up[vt] * Ja * I.pixel) * Za, qr = _.point ?? [_o(0), _o(1), _o(2)];
    Q(Wn($, qr, T, Ll, P)), P && De($.eye, qr) < 0.5 && (_ = null);
  }
  function A(h) {
    if (h.target.closest("[data-scroll]")) return;
    h.preventDefault();
    let v = h.deltaMode === 1 ? 18 : h.deltaMode === 2 ? 400 : 1, [T, P] = [h.deltaX * v, h.deltaY * v], [$, I] = u(h);
    if (Gn.peek() === "trackpad" && !h.ctrlKey) return Ft(-T, -P, r);
    let R = (h.ctrlKey ? 6 : 1) * (Math.abs(P) > Math.abs(T) ? P : T);
    b($, I, Math.exp(Math.max(-300, Math.min(300, R)) * 16e-4), h.shiftKey && !h.ctrlKey);
  }
  let L = (h) => h.preventDefault(), Fe = () => {
    clearTimeout(a), t.unhover();
  }, Ne = (h) => {
    !h.target.closest("[data-handle]") && z.peek() === null && t.double();
  }, ye = (h) => {
    h.code === "Space" && (i = h.type === "keydown");
  }, me = new ResizeObserver(() => {
    let h = e.getBoundingClientRect();
    be.value = [Math.max(16, Math.round(h.width)), Math.max(16, Math.round(h.height))];
  });
  return me.observe(e), e.addEventListener("pointerdown", f), e.addEventListener("pointermove", w), e.addEventListener("pointerup", x), e.addEventListener("pointercancel", x), e.addEventListener("pointerleave", Fe), e.addEventListener("wheel", A, { passive: !1 }), e.addEventListener("contextmenu", L), e.addEventListener("dblclick", Ne), addEventListener("keydown", ye), addEventListener("keyup", ye), () => {
    me.disconnect(), removeEventListener("keydown", ye), removeEventListener("keyup", ye);
  };
}

// src/overlay.ts
var Il = "http://www.w3.org/2000/svg";
function _e(e, t = {}, n) {
  let o = document.createElementNS(Il, e);
  for (let [r, i] of Object.entries(t)) o.setAttribute(r, String(i));
  return n?.append(o), o;
}
var Fr = class {
  view;
  fit;
  constructor(t) {
    this.view = t, this.fit = dn(t.width, t.height);
  }
  at(t) {
    let [n, o, r] = cn(this.view, t);
    return r < 0.02 && !this.view.parallel ? null : [this.fit.x + n * this.fit.scale, this.fit.y + o * this.fit.scale];
  }
  /** A line of the scene as a path, as much of it as lies before the eye. */
  line(t, n) {
    let [, , o] = cn(this.view, t), [, , r] = cn(this.view, n), i = 0.05, [a, s] = [t, n];
    if (!this.view.parallel) {
      if (o < i && r < i) return "";
      let u = (i - o) / (r - o), p = V(S(t, 1 - u), S(n, u));
      o < i && (a = p), r < i && (s = p);
    }
    let [d, c] = [this.at(a), this.at(s)];
    return !d || !c ? "" : `M${d[0].toFixed(1)} ${d[1].toFixed(1)}L${c[0].toFixed(1)} ${c[1].toFixed(1)}`;
  }
};
function Nr() {
  let e = W.value;
  return be.value, e ? new Fr($t(e.camera, e.head.width, e.head.height)) : null;
}
function qa() {
  let e = ie(Nr);
  return e ? k.all().flatMap(([t, n]) => {
    let o = ja(n), r = o && e.at(o);
    return r ? [{ id: t, at: r }] : [];
  }) : null;
}
var ja = fr, Al = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
function Or(e, t) {
  let n = Pt(t);
  return Al.map(([o, r]) => e.line(n[o], n[r])).join("");
}
var xn = class {
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
        let d = _e("g", { "data-kind": this.kind, "data-id": o }, this.parent);
        this.shape(d);
        let c = _e("text", { x: 10, y: 4 }, d);
        s = { group: d, label: c }, this.marks.set(o, s);
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
function Ua(e) {
  let t = _e("path", { class: "aims" }, e), n = _e("path", { class: "boxes" }, e), o = _e("path", { class: "boxes hover" }, e), r = _e("path", { class: "grid-lines" }, e), i = new xn(_e("g", {}, e), "lamp", (u) => _e("circle", { r: 4.5 }, u)), a = new xn(_e("g", {}, e), "grid", () => {
  }), s = new xn(_e("g", {}, e), "meter", (u) => {
    _e("circle", { r: 5.5 }, u), _e("path", { d: "M-9 0H9M0 -9V9" }, u);
  }), d = C(() => {
    let u = Nr();
    if (!u) return;
    let p = E.value, m = pe.value, f = "", y = "", w = k.all().map(([_, b]) => {
      let A = p?.kind === "lamp" ? p.ids.includes(_) : p?.kind === "group" && p.ids.includes(b.group ?? -1), L = m?.kind === "lamp" ? m.id === _ : m?.kind === "group" && m.id === b.group, Fe = ja(b), Ne = b.place?.position;
      if (A && b.box && (y += Or(u, b.box)), Ne && b.place?.direction && (A || L)) {
        let h = b.place.aim ?? V(Ne, b.place.direction);
        f += u.line(Ne, h);
      }
      let ye = A || L || er.value && (b.own || b.place?.position), me = `${A ? "selected" : ""} ${L ? "under" : ""} ${Re(b) ? "" : "off"}`;
      return { id: _, at: Fe && ye ? u.at(Fe) : null, label: A || L ? b.name : "", state: me };
    });
    if (i.draw(w), t.setAttribute("d", f), p?.kind === "thing")
      for (let _ of p.ids) {
        let b = he.get(_)?.box;
        b && (y += Or(u, b));
      }
    n.setAttribute("d", y);
    let x = m?.kind === "lamp" ? k.get(m.id)?.box : m?.kind === "thing" ? he.get(m.id)?.box : null;
    o.setAttribute("d", x ? Or(u, x) : "");
  }), c = C(() => {
    let u = Nr();
    if (!u) return;
    let p = E.value, m = (y, w) => p?.kind === y && p.ids.includes(w) ? "selected" : "";
    s.draw(St.all().map(([y, w]) => ({
      id: y,
      at: u.at(w.point),
      label: w.lux ? dt(w.lux[0]) : "…",
      state: m("meter", y)
    })));
    let f = "";
    a.draw(Dn.all().map(([y, w]) => {
      f += Rl(u, w);
      let x = w.mean == null ? "…" : `${w.name} ${dt(w.mean)}`;
      return { id: y, at: u.at(w.corner), label: x, state: m("grid", y) };
    })), r.setAttribute("d", f);
  });
  return () => {
    d(), c(), e.replaceChildren();
  };
}
function Rl(e, t) {
  let n = (r, i) => V(t.corner, V(S(t.u, r), S(t.v, i))), o = e.line(n(0, 0), n(1, 0)) + e.line(n(1, 0), n(1, 1)) + e.line(n(1, 1), n(0, 1)) + e.line(n(0, 1), n(0, 0));
  for (let r = 0; r < t.rows; r++)
    for (let i = 0; i < t.columns; i++) {
      let a = e.at(n((i + 0.5) / t.columns, (r + 0.5) / t.rows));
      a && (o += `M${(a[0] - 2).toFixed(1)} ${a[1].toFixed(1)}h4m-2 -2v4`);
    }
  return o;
}

// src/banner.tsx
function ce({ tone: e, children: t }) {
  return l("div", { class: `banner ${e}`, role: e === "warn" ? "alert" : "status", children: t });
}
var Wa = () => `lampyris view ${J.peek()?.file ?? "SCENE"} --port ${location.port || 80}`;
function Hl() {
  let e = k.all().filter(([, n]) => !n.on || n.level === 0 || n.parked), t = K.all().filter(([, n]) => !n.on || n.level === 0);
  Te("All lamps on", {
    lamps: Object.fromEntries(e.map(([n, o]) => [n, { on: !0, parked: !1, ...o.level === 0 ? { level: 1 } : {} }])),
    groups: Object.fromEntries(t.map(([n, o]) => [n, { on: !0, ...o.level === 0 ? { level: 1 } : {} }]))
  });
}
function Kl() {
  switch (Wt.value) {
    case "starting":
      return l(ce, { tone: "calm", children: "Entering…" });
    case "loading": {
      let e = Dr.value;
      return l(ce, { tone: "calm", children: [
        "Reading ",
        e?.file ?? J.value?.file ?? "the scene",
        "…",
        e?.bytes ? ` ${B(e.bytes / 1e6, 1)} MB` : "",
        e?.progress != null && l("progress", { value: e.progress, max: 1, "aria-label": "Reading" })
      ] });
    }
    case "lost":
      return l(ce, { tone: "warn", children: [
        "Connection lost, trying again",
        sn.value ? ` (${sn.value} s)` : "…",
        ". Until then nothing can be changed."
      ] });
    case "ended":
      return l(ce, { tone: "warn", children: [
        l("span", { children: [
          "The program has ended. Start it again with ",
          l("code", { children: Wa() }),
          ": this page comes back by itself."
        ] }),
        l("button", { onClick: () => {
          hr(Wa());
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
        wn.value,
        " Still showing what was read before."
      ] });
    case "control-lost":
      return l(ce, { tone: "warn", children: [
        l("span", { children: [
          "Control moved to ",
          l("em", { children: kn.value }),
          "."
        ] }),
        " ",
        l("button", { onClick: () => D({ do: "edit", what: "take" }), children: "Take it back" })
      ] });
    case "watching":
      return l(ce, { tone: "calm", children: [
        l("span", { children: [
          "You are watching",
          j.value.name ? l(X, { children: [
            "; ",
            l("em", { children: j.value.name }),
            " edits"
          ] }) : "",
          "."
        ] }),
        l("button", { onClick: () => D({ do: "edit", what: "take" }), children: "Ask for control" })
      ] });
    case "no-lamps":
      return l(ce, { tone: "calm", children: [
        "This scene has no light. Add:",
        l(
          "button",
          {
            onClick: () => {
              ur.value = "disc", cr("add");
            },
            children: "ceiling lamp"
          }
        ),
        l("button", { disabled: !0, title: "Photometric files come with a later version", children: "IES file" })
      ] });
    case "all-off":
      return l(ce, { tone: "warn", children: [
        "All lamps are off.",
        rt.value.undo && l("button", { onClick: () => oe("undo"), children: "Undo" }),
        l("button", { onClick: Hl, children: "Turn on" })
      ] });
    case "slow":
      return l(ce, { tone: "calm", children: [
        "Slow connection.",
        l("button", { "aria-pressed": Ge.value, onClick: () => Ge.value = !0, children: "Sharper" }),
        l("button", { "aria-pressed": !Ge.value, onClick: () => Ge.value = !1, children: "Faster" })
      ] });
    default:
      return null;
  }
}
function Ba() {
  let e = we.value;
  return l("div", { class: "banners", "data-scroll": !0, children: [
    Kl(),
    Ze.value.length > 0 && l(ce, { tone: "calm", children: [
      l("details", { children: [
        l("summary", { children: [
          Ze.value.length,
          " edits no longer find what they changed"
        ] }),
        l("ul", { children: Ze.value.map((t) => l("li", { children: t }, t)) })
      ] }),
      l("button", { onClick: () => Ze.value = [], children: "Good" })
    ] }),
    e.length > 0 && l("div", { class: "banner badge", role: "status", children: [
      "Solo: ",
      e.length === 1 ? k.get(e[0])?.name ?? "one lamp" : `${e.length} lamps`,
      l("button", { onClick: wr, children: "End solo" })
    ] }),
    l("div", { class: "notes", role: "status", "aria-live": "polite", children: st.value.map((t) => l("div", { class: `banner ${t.tone === "warn" ? "warn" : "calm"}`, children: [
      t.text,
      l("button", { class: "icon", "aria-label": "Close", onClick: () => Fo(t.id), children: l(G, { name: "close" }) })
    ] }, t.id)) })
  ] });
}

// src/view.tsx
var Ga = g(null);
function Dl(e, t) {
  let n = qa();
  if (!n) return [];
  let [o, r] = [Math.min(e[0], t[0]), Math.max(e[0], t[0])], [i, a] = [Math.min(e[1], t[1]), Math.max(e[1], t[1])];
  return n.filter(({ at: s }) => s[0] >= o && s[0] <= r && s[1] >= i && s[1] <= a).map(({ id: s }) => s);
}
var Ol = {
  click(e, t, n) {
    let o = za(e, t);
    if (z.peek() === null && o) return Xe(o.kind, o.id, n);
    bo(e, t, (r) => {
      if (r && (Jn.value = { point: r.point, normal: r.normal }), z.peek() !== null) return ia(r);
      Zi(r, n), E.peek() && (Ve.value = "inspector");
    });
  },
  menu(e, t) {
    bo(e, t, (n) => {
      n && lo(e, t, n);
    });
  },
  double() {
    sr();
  },
  hover(e, t) {
    let n = za(e, t);
    n?.kind === "lamp" && (pe.value = { kind: "lamp", id: n.id }), bo(e, t, (o) => {
      go.value = o, o && (Jn.value = { point: o.point, normal: o.normal }), o?.lamp != null && (pe.value = { kind: "lamp", id: o.lamp });
    });
  },
  unhover() {
    pe.peek() && (pe.value = null);
  },
  marquee(e, t, n) {
    if (Ga.value = n ? null : { from: e, to: t }, !n) return;
    let o = Dl(e, t);
    E.value = o.length ? { kind: "lamp", ids: o } : null, z.value = null;
  }
};
function za(e, t) {
  let n = document.getElementById("overlay"), o = null, r = 11;
  for (let i of n?.querySelectorAll(".mark:not([display])") ?? []) {
    let a = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(i.getAttribute("transform") ?? "");
    if (!a) continue;
    let s = Math.hypot(Number(a[1]) - e, Number(a[2]) - t);
    s < r && (r = s, o = { kind: i.dataset.kind, id: Number(i.dataset.id) });
  }
  return o;
}
var Fl = {
  aim: "Click what shall be lit. Esc to leave.",
  meter: "Click where the meter shall lie. Esc to leave.",
  grid: "Click two opposite corners of the area. Esc to leave.",
  add: "Click where the lamp shall hang. Esc to leave.",
  marquee: "Drag around the lamps to select. Esc to leave."
};
function Xa() {
  let e = te(null), t = te(null), n = te(null);
  return Se(() => {
    Go(t.current);
    let o = Ua(n.current), r = Na(e.current, Ol);
    return () => {
      Go(null), o(), r();
    };
  }, []), ki(() => {
    let o = W.value;
    t.current?.setAttribute("data-kind", o?.head.kind ?? "none");
  }), l("main", { class: "view", "aria-label": "View", children: [
    l(
      "div",
      {
        class: z.value ? "stage tooled" : "stage",
        id: "view",
        ref: e,
        tabIndex: 0,
        role: "application",
        "aria-label": `View of ${J.value?.name ?? "the scene"}${Kt.value ? `, ${Kt.value}` : ""}`,
        "aria-describedby": "view-keys",
        "data-tool": z.value ?? "",
        children: [
          l("canvas", { ref: t, width: 640, height: 480, "aria-hidden": "true" }),
          l("svg", { id: "overlay", ref: n, "aria-hidden": "true" }),
          l(ee, { part: "Gizmo" }),
          l(ee, { part: "Compare" }),
          l(Nl, {})
        ]
      }
    ),
    l("p", { id: "view-keys", class: "spoken", children: "Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection, Escape leaves the view." }),
    z.value && l("p", { class: "hint", role: "status", children: Fl[z.value] }),
    l(Ba, {}),
    l(ee, { part: "Legend" }),
    l(ee, { part: "CutBar" }),
    l(ee, { part: "ViewStrip" }),
    l(ee, { part: "WalkPad" }),
    l(ee, { part: "What" })
  ] });
}
function Nl() {
  let e = Ga.value;
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
function ql() {
  return l(X, { children: [
    l(ha, {}),
    l(Ha, {}),
    l(Xa, {}),
    l("section", { class: "panel inspector", "aria-label": "Inspector", children: l(ee, { part: "Inspector" }) }),
    l("section", { class: "strip", "aria-label": "Looks and meters", children: l(ee, { part: "Strip" }) }),
    l(Oa, {}),
    l(ee, { part: "Sheets" })
  ] });
}
var ht = document.getElementById("desk");
ht.replaceChildren();
ni(l(ql, {}), ht);
C(() => {
  ht.dataset.state = Wt.value, ht.dataset.line = U.value, ht.dataset.pen = fe.value === "edit" && j.value.you && !$e.value ? "yes" : "no";
});
C(() => {
  ht.dataset.panels = Jo.value ? "yes" : "no", ht.dataset.drawer = Ve.value ?? "none";
});
C(() => {
  document.documentElement.dataset.theme = Xo.value, document.documentElement.style.setProperty("--house", String(Yo.value));
});
C(() => {
  J.value && (document.title = `${J.value.name} – Lampyris`);
});
var Ya = 0;
C(() => {
  let [e, t] = be.value, n = Ge.value ? Math.min(devicePixelRatio, 2) : 1;
  U.value !== "open" || fe.value === "watch" || !j.value.you || (clearTimeout(Ya), Ya = window.setTimeout(() => D({ do: "size", width: Math.round(e * n), height: Math.round(t * n) }), 60));
});
ca();
Ca();
Ai();
export {
  yn as Fade,
  gn as Field,
  X as Fragment,
  We as Gesture,
  G as Icon,
  _r as Item,
  Ls as PRESETS,
  Ir as Range,
  Hr as Virtual,
  ut as across,
  oe as act,
  V as add,
  ur as adding,
  ol as allActions,
  xe as ask,
  qs as back,
  mn as before,
  At as candles,
  le as chosenLamps,
  wr as clearSolo,
  uo as closeWhat,
  $a as colorText,
  oo as command,
  hn as compareHeld,
  de as comparing,
  Wi as compass,
  q as computed,
  hr as copyText,
  Ar as cost,
  ve as cross,
  Vr as css,
  Gs as cut,
  Yn as deselect,
  B as digits,
  at as display,
  De as distance,
  F as dot,
  Qs as each,
  Te as edit,
  j as editor,
  C as effect,
  ro as exposeBy,
  tr as fade,
  Zs as falseColor,
  ks as filterOf,
  Ge as fine,
  dn as fitted,
  vn as format,
  js as forth,
  sr as frameSelection,
  to as free,
  Sl as fromHex,
  Q as go,
  lr as goHome,
  zs as goInside,
  Bs as goPreset,
  Dn as grids,
  K as groups,
  Os as handles,
  Gn as hands,
  ke as hear,
  ne as here,
  Ta as hex,
  so as highlight,
  rt as history,
  Yo as houseLights,
  pe as hovered,
  l as jsx,
  l as jsxs,
  er as lampMarks,
  k as lamps,
  on as layers,
  Ke as length,
  It as listing,
  $e as lookOnly,
  xt as looks,
  dt as luxText,
  Ks as maintenance,
  wt as materials,
  St as meters,
  Be as middle,
  Ml as mired,
  Ji as nameOf,
  Z as normal,
  Ys as onTool,
  Re as output,
  _l as padWalk,
  Jo as panels,
  Ie as percent,
  Rr as pickRow,
  $t as pinhole,
  fr as positionOf,
  cn as project,
  $s as ray,
  nl as register,
  fe as role,
  ae as say,
  S as scale,
  J as scene,
  Xe as select,
  E as selection,
  D as send,
  Xs as setCut,
  pt as sheet,
  Tt as show,
  W as shown,
  g as signal,
  Zo as singleKeys,
  cl as soloSelection,
  Jn as spot,
  cr as startTool,
  Ce as status,
  Ts as step,
  Fs as stepSelection,
  tl as storeLook,
  el as storeView,
  Uo as stroke,
  mo as strokeLevel,
  O as sub,
  Lr as switchOn,
  Xo as theme,
  he as things,
  Qe as three,
  Qn as titleOf,
  Er as toLevel,
  Cr as toTravel,
  mr as toggleFalse,
  al as toggleWipe,
  z as tool,
  Xn as travel,
  un as turn,
  $r as typeGroupLevel,
  Pr as typeLevel,
  Le as up,
  Se as useEffect,
  us as useLayoutEffect,
  te as useRef,
  Kt as viewName,
  be as viewSize,
  kt as views,
  Sa as walkNames,
  Qo as walking,
  dr as wantLevel,
  Je as what,
  jn as whyNot,
  vr as whyNotTo,
  rl as wipeAt
};
