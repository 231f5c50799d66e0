// node_modules/preact/dist/preact.mjs
var C, zr, So, Ne, ko, En, Gr, Mn, Xr, Mo, xo, os, zt = /* @__PURE__ */ Symbol.for("pv"), Tn = {}, Pn = [], rs = /^m(i|n|o|s|text|space)$/, Co = Array.isArray, Eo = Pn.slice, tt = Object.assign;
function et(e) {
  e && e.parentNode && e.remove();
}
function Yr(e, t, n) {
  var o, r, i, a = {}, s = arguments.length;
  for (i in t) i == "key" ? o = t[i] : i == "ref" && typeof e != "function" ? r = t[i] : a[i] = t[i];
  return s > 2 && (a.children = s > 3 ? Eo.call(arguments, 2) : n), Bt(e, a, o, r, null);
}
function Bt(e, t, n, o, r) {
  var i = { type: e, props: t, key: n, ref: o, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: zt, __v: r || ++zr, __i: -1, __u: 0 };
  return !r && C.vnode && C.vnode(i), i;
}
function X(e) {
  return e.children;
}
function gt(e, t) {
  this.props = e, this.context = t, this.__g = 0;
}
function qe(e, t) {
  if (t == null) return e.__ && qe(e.__, e.__i + 1);
  for (var n; t < e.__k.length; t++) if ((n = e.__k[t]) && n.__e) return n.__e;
  return typeof e.type != "function" || e.props.__P ? null : qe(e);
}
function is(e) {
  var t, n = e.__v, o = n.__e, r = [], i = [], a = e.__P;
  a && ((t = tt({ constructor: zt }, n)).__v = n.__v + 1, C.vnode && C.vnode(t), To(a, t, n, e.__n, a.namespaceURI, 32 & n.__u ? [o] : null, r, o || qe(n), 32 & n.__u, i), t.__v = n.__v, t.__.__k[t.__i] = t, ni(r, t, i), n.__ = n.__e = null, t.__e != o && Qr(t));
}
function Qr(e) {
  if ((e = e.__) && e.__c && !e.props.__P) return e.__e = null, e.__k.some(function(t) {
    return t && (e.__e = t.__e);
  }), Qr(e);
}
function Wr(e) {
  (8 & e.__g || (e.__g |= 8, Ne.push(e), En++)) && ko == C.debounceRendering || ((ko = C.debounceRendering) || queueMicrotask)(Jr);
}
function Jr() {
  try {
    for (var e, t = 1; Ne.length; ) Ne.length > t && Ne.sort(Gr), e = Ne.shift(), t = Ne.length, 8 & e.__g && is(e);
  } finally {
    (En = Ne.length) && (ko || queueMicrotask)(Jr);
  }
}
function Zr(e, t, n, o, r, i, a, s, p, c, u) {
  var d, m, f, y, _, w, M = o.__k || Pn, b = t.length;
  for (p = as(n, t, M, p, b), d = 0; d < b; d++) (f = n.__k[d]) != null && (m = ~f.__i && M[f.__i] || Tn, f.__i = d, w = To(e, f, m, r, i, a, s, p, c, u), y = f.__e, (m.ref != f.ref || 8 & m.__u) && (m.ref && Po(m.ref, null, f, m), f.ref && u.push(f.ref, f.__c || y, f)), _ = _ || y, 4 & f.__u ? (p = ei(f, p, e, !m.__v), m.__e && (m.__e = null)) : typeof f.type == "function" && w !== void 0 ? p = w : y && (p = y.nextSibling), f.__u &= -21);
  return n.__e = _, p;
}
function as(e, t, n, o, r) {
  var i, a, s, p, c, u, d, m, f, y = n.length, _ = y, w = 0, M = 0, b = e.__k = Array(r);
  for (i = 0; i < r; i++) (a = t[i]) != null && typeof a != "boolean" && typeof a != "function" ? (typeof a != "object" || a.constructor === String ? a = b[i] = Bt(null, a) : Co(a) ? a = b[i] = Bt(X, { children: a }) : a.constructor === zt && a.__b ? a = b[i] = Bt(a.type, a.props, a.key, a.ref, a.__v) : b[i] = a, p = i + w, a.__ = e, a.__b = e.__b + 1, s = null, ~(c = a.__i = ss(a, n, p, _)) && (_--, (s = n[c]) && (s.__u |= 2)), s && s.__v ? (a.__u |= 16, c == p - 1 ? w-- : c == p + 1 ? w++ : c != p && (c > p ? w-- : w++, M = 1)) : (~c || (r > y ? w-- : r < y && w++), typeof a.type != "function" && (a.__u |= 4))) : b[i] = null;
  if (M) {
    for (u = [], d = [], i = 0; i < r; i++) if ((a = b[i]) && 16 & a.__u) {
      for (w = 0, m = u.length; w < m; ) u[f = w + m >> 1] < a.__i ? w = f + 1 : m = f;
      u[w] = a.__i, d[i] = w + 1;
    }
    for (w = u.length; i--; ) d[i] && (d[i] == w ? w-- : b[i].__u |= 4);
  }
  if (_) for (i = 0; i < y; i++) !(s = n[i]) || 2 & s.__u || (s.__e == o && (o = qe(s)), $o(s, s));
  return o;
}
function ei(e, t, n, o) {
  var r, i, a, s;
  if (typeof e.type == "function") {
    if (e.props.__P) return t;
    if (r = e.__k) for (i = 0; i < r.length; i++) r[i] && (r[i].__ = e, t = ei(r[i], t, n, !1));
    return t;
  }
  for (t && !t.parentNode && (t = qe(e)) && !t.parentNode && (t = null), a = e.__e, s = t; s && s.nodeType == 8; ) s = s.nextSibling;
  for (a != s && (!o && n.moveBefore && a.parentNode ? n.moveBefore(a, t) : n.insertBefore(a, t || null)), t = a; (t = t && t.nextSibling) && t.nodeType == 8 && !t.data.startsWith("$s"); ) ;
  return t;
}
function ss(e, t, n, o) {
  var r, i = e.key, a = e.type, s = t[n], p = s && !(2 & s.__u);
  if (s === null && i == null || p && i == s.key && a == s.type) return n;
  if (o > (p ? 1 : 0)) {
    for (r = n - 1; r >= 0; r--) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
    for (r = n + 1; r < t.length; r++) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
  }
  return -1;
}
function Br(e, t, n) {
  n == null && (n = ""), t[0] == "-" ? e.setProperty(t, n) : e[t] = n;
}
function Sn(e, t, n, o, r) {
  var i, a;
  if (t == "style") if (typeof n == "string") e.style.cssText = n;
  else {
    if (typeof o == "string" && (e.style.cssText = o = ""), o) for (t in o) n && t in n || Br(e.style, t);
    if (n) for (t in n) o && n[t] == o[t] || Br(e.style, t, n[t]);
  }
  else if (t[0] == "o" && t[1] == "n") typeof n != "function" && (n = null), typeof o != "function" && (o = null), (e.__e || (e.__e = {}))[t] = n, n && o || (a = xo[t] || (xo[t] = ls(t)), (e.__a || (e.__a = {}))[t] = Mo, i = t != (t = t.replace(Xr, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), n ? e.addEventListener(t, a, i) : e.removeEventListener(t, a, i));
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
function ls(e) {
  return function(t) {
    var n = this.__e;
    if (n) {
      if (n = n[e], t[Mn] == null) t[Mn] = Mo++;
      else if (t[Mn] < this.__a[e]) return;
      return n(C.event ? C.event(t) : t);
    }
  };
}
function To(e, t, n, o, r, i, a, s, p, c) {
  var u, d, m, f, y, _, w, M, b, k, V, Me, Ze, fe, he, h, v, P, $ = t.type;
  if (t.constructor !== zt) return null;
  128 & n.__u && (p = 32 & n.__u, u = n.__c.__z) && (t.__u |= p, d = i = [], u.nodeType == 8 ? s = Cn(u, i) : i.push(u), s = i[0] || s), (u = C.__b) && u(t);
  e: if (typeof $ == "function") {
    m = a.length;
    try {
      if (M = t.props, b = (u = $.prototype) && u.render, k = (u = $.contextType) && o[u.__c], V = u ? k ? k.props.value : u.__ : o, (f = n.__c) ? (t.__c = f, 2 & f.__g && (f.__g |= 1)) : (b ? t.__c = f = new $(M, V) : (t.__c = f = new gt(M, V), f.constructor = $, f.render = cs), k && k.sub(f), f.state || (f.state = {}), f.__n = o, f.__g |= 8, f.__h = [], f.__k = []), b && (f.__s || (f.__s = f.state), $.getDerivedStateFromProps && (f.__s == f.state && (f.__s = tt({}, f.__s)), tt(f.__s, $.getDerivedStateFromProps(M, f.__s)))), y = f.props, _ = f.state, f.__v = t, n.__c) {
        if (M !== y && b && !$.getDerivedStateFromProps && f.componentWillReceiveProps && f.componentWillReceiveProps(M, V), t.__v == n.__v && !(8 & f.__g) || !(4 & f.__g) && f.shouldComponentUpdate && f.shouldComponentUpdate(M, f.__s, V) === !1) {
          t.__v != n.__v && (f.props = M, f.state = f.__s, f.__g &= -9), t.__e = n.__e, t.__k = n.__k, t.__k.some(function(L) {
            L && (L.__ = t);
          }), Pn.push.apply(f.__h, f.__k), f.__k = [], f.__h.length && a.push(f), s = qe(n);
          break e;
        }
        f.componentWillUpdate && f.componentWillUpdate(M, f.__s, V), b && f.componentDidUpdate && f.__h.push(function() {
          f.componentDidUpdate(y, _, w);
        });
      } else b && !$.getDerivedStateFromProps && f.componentWillMount && f.componentWillMount(), b && f.componentDidMount && f.__h.push(f.componentDidMount);
      f.context = V, f.props = M, f.__P = e, f.__g &= -5, Me = C.__r, Ze = b ? 25 : 0;
      do
        f.__g &= -9, Me && Me(t), u = f.render(f.props, f.state = f.__s, f.context);
      while (8 & f.__g && ++Ze < 25);
      b && (Pn.push.apply(f.__h, f.__k), f.__k = []), f.state = f.__s, f.getChildContext && (o = tt({}, o, f.getChildContext())), b && n.__c && f.getSnapshotBeforeUpdate && (w = f.getSnapshotBeforeUpdate(y, _)), fe = u && u.type === X && u.key == null ? u.props.children : u, M.__P && (u = s, r = (e = M.__P).namespaceURI, p = i = null, n.props && n.props.__P != e && (n.__k.some(function(L) {
        L && $o(L, L);
      }), n.__k = null), s = n.__k ? qe(n, 0) : null), s = Zr(e, Co(fe) ? fe : [fe], t, n, o, r, i, a, s, p, c), M.__P && (t.__e = null, s = u), t.__u &= -161, d && d.some(et), f.__h.length && a.push(f), 1 & f.__g && (f.__g &= -4);
    } catch (L) {
      if (a.length = m, t.__v = null, p || i) if (L && L.then) {
        if (t.__u |= 128 | p, i) {
          for (~(v = i.indexOf(s || void 0)) || (v = i.length); (P = i[v - 1]) && P.nodeType == 8; ) v--;
          for (; v < i.length; v++) if (P = i[v]) if (i[v] = null, he) {
            if (P == h) break;
          } else {
            if (P.nodeType != 8) break;
            P.data.startsWith("$s") && (h = Cn(he = P));
          }
        }
        if (!he) {
          for (; s && s.nodeType == 8 && s.nextSibling; ) s = s.nextSibling;
          he = s;
        }
        (u = Cn(he = t.__c.__z || (t.__c.__z = he))) ? (t.__e = he, s = u) : t.__e = s, s = s && s.nextSibling;
      } else i && i.some(et);
      else t.__e = n.__e;
      t.__k || (t.__k = n.__k || []), L && L.then || ti(t), C.__e(L, t, n);
    }
  } else s = t.__e = us(n.__e, t, n, o, r, i, a, p, c, e);
  return (u = C.diffed) && u(t), s;
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
function ti(e) {
  e && (e.__c && (e.__c.__g |= 4), e.__k && e.__k.some(ti));
}
function ni(e, t, n) {
  for (var o = 0; o < n.length; ) Po(n[o++], n[o++], n[o++]);
  C.__c && C.__c(t, e), e.some(function(r) {
    try {
      e = r.__h, r.__h = [], e.some(function(i) {
        i.call(r);
      });
    } catch (i) {
      C.__e(i, r.__v);
    }
  });
}
function us(e, t, n, o, r, i, a, s, p, c) {
  var u, d, m, f, y, _, w, M, b = n.props || Tn, k = t.props, V = t.type;
  if (V == "svg" ? r = "http://www.w3.org/2000/svg" : V == "math" ? r = "http://www.w3.org/1998/Math/MathML" : r || (r = "http://www.w3.org/1999/xhtml"), i) {
    for (u = 0; u < i.length; u++) if ((y = i[u]) && (V ? y.localName == V : y.nodeType == 3)) {
      e = y, i[u] = null;
      break;
    }
  }
  if (!e) {
    if (M = c.ownerDocument || document, !V) return M.createTextNode(k);
    e = M.createElementNS(r, V, k.is ? k : c), s && (C.__m && C.__m(t, i), s = !1), i = null;
  }
  if (V) {
    if (c = V == "template" && e.content || e, i = V == "textarea" && k.defaultValue != null ? null : i && Eo.call(c.childNodes), !s && i) for (b = {}, u = 0; u < e.attributes.length; u++) b[(y = e.attributes[u]).name] = y.value;
    for (u in b) y = b[u], u == "dangerouslySetInnerHTML" ? m = y : u == "children" || u in k || u == "value" && "defaultValue" in k || u == "checked" && "defaultChecked" in k || Sn(e, u, null, y, r);
    for (u in k) y = k[u], u == "children" ? f = y : u == "dangerouslySetInnerHTML" ? d = y : u == "value" ? _ = y : u == "checked" ? w = y : s && typeof y != "function" || b[u] === y || Sn(e, u, y, b[u], r);
    d ? (s || m && (d.__html == m.__html || d.__html == e.innerHTML) || (e.innerHTML = d.__html), t.__k = []) : (m && (e.textContent = ""), (V == "foreignObject" || r == "http://www.w3.org/1998/Math/MathML" && rs.test(V)) && (r = "http://www.w3.org/1999/xhtml"), Zr(c, Co(f) ? f : [f], t, n, o, r, i, a, i ? i[0] : n.__k && qe(n, 0), s, p), i && i.some(et)), s && V != "textarea" || (u = "value", V == "progress" && _ == null ? e.removeAttribute(u) : _ == null || _ === e[u] && (V != "progress" || _) || Sn(e, u, _, b[u], r), u = "checked", w != null && w != e[u] && Sn(e, u, w, b[u], r));
  } else b === k || s && e.data == k || (e.data = k);
  return e;
}
function Po(e, t, n, o) {
  try {
    typeof e == "function" ? t ? t.__x = e(t) || 1 : o && (o = o.__c || o.__e) && (t = o.__x) && (o.__x = null, typeof t == "function" ? t() : e(null)) : e.current = t;
  } catch (r) {
    C.__e(r, n);
  }
}
function $o(e, t, n) {
  var o, r, i, a;
  if (C.unmount && C.unmount(e), !(o = e.ref) || o.current && o.current != e.__e || Po(o, null, t, e), o = e.__c) {
    if (o.componentWillUnmount) try {
      o.componentWillUnmount();
    } catch (s) {
      C.__e(s, t);
    }
    o.__P = o.__n = null;
  }
  if (o = e.__k) for (a = 0; a < o.length; a++) o[a] && $o(o[a], t, typeof e.type != "function" || n && !e.props.__P);
  !n && (o = e.__c) && (o = o.__z) && (r = Cn(o, i = [])) && (o == e.__e && i.some(et), et(r), et(o)), n || et(e.__e), e.__e = e.__c = e.__ = null;
}
function cs(e, t, n) {
  return this.constructor(e, n);
}
function oi(e, t) {
  var n, o, r, i;
  C.__ && C.__(e, t), t.nodeType == 9 && (t = t.documentElement), o = (n = e && 32 & e.__u) ? null : t.__k, t.__k = Bt(X, { children: [e] }), r = [], i = [], To(t, t.__k, o || Tn, Tn, t.namespaceURI, o ? null : t.firstChild ? Eo.call(t.childNodes) : null, r, o ? o.__e : t.firstChild, n, i), ni(r, t.__k, i), t.__k.props.children = null;
}
C = { __e: function(e, t, n, o) {
  for (var r, i, a; t = t.__; ) if ((r = t.__c) && !(1 & r.__g)) {
    r.__g |= 4;
    try {
      if ((a = (i = r.constructor) && i.getDerivedStateFromError) && r.setState(i.getDerivedStateFromError(e)), r.componentDidCatch && (r.componentDidCatch(e, o || {}), a = 1), a && 8 & r.__g) return void (r.__g |= 2);
    } catch (s) {
      e = s;
    }
  }
  throw En = 0, e;
} }, zr = 0, So = function(e) {
  return e != null && e.constructor === zt;
}, gt.prototype.setState = function(e, t) {
  var n = this.__s;
  n && n != this.state || (n = this.__s = tt({}, this.state)), typeof e == "function" && (e = e(tt({}, n), this.props)), e && (tt(n, e), this.__v && (t && this.__k.push(t), Wr(this)));
}, gt.prototype.forceUpdate = function(e) {
  this.__v && (this.__g |= 4, e && this.__h.push(e), Wr(this));
}, gt.prototype.render = X, Ne = [], En = 0, Gr = function(e, t) {
  return e.__v.__b - t.__v.__b;
}, Mn = /* @__PURE__ */ Symbol(), Xr = /(PointerCapture)$|Capture$/i, Mo = 0, xo = {}, os = 0;

// node_modules/preact/hooks/dist/hooks.mjs
var Xt, re, Lo, ri, fs = Object.is, Vo = 0, di = [], Io = [], j = C, ii = j.__b, ai = j.__r, si = j.diffed, li = j.__c, ui = j.unmount, ci = j.__;
function Ro(e, t) {
  j.__h && j.__h(re, e, Vo || t), Vo = 0;
  var n = re.__H || (re.__H = { __: [], __h: [] });
  return e >= n.__.length && n.__.push({}), n.__[e];
}
function Ce(e, t) {
  var n = Ro(Xt++, 3);
  !j.__s && Ho(n.__H, t) && (n.__P = !0, n.__ = e, n.u = t, re.__H.__h.push(n));
}
function ps(e, t) {
  var n = Ro(Xt++, 4);
  !j.__s && Ho(n.__H, t) && (n.__P = !1, n.__ = e, n.u = t, re.__h.push(n));
}
function te(e) {
  return Vo = 5, $n(function() {
    return { current: e };
  }, []);
}
function $n(e, t) {
  var n = Ro(Xt++, 7);
  return Ho(n.__H, t) && (n.__ = e(), n.__H = t), n.__;
}
function ds() {
  var e;
  do {
    for (; e = Io.shift(); ) try {
      Gt(e);
    } catch (n) {
      j.__e(n, { __: (e = e.__P) && e.__v });
    }
    for (; e = di.shift(); ) {
      var t = e.__H;
      if (e.__P && t) try {
        t.__h.some(Gt), t.__h.some(Ao), t.__h = [];
      } catch (n) {
        t.__h = [], j.__e(n, e.__v);
      }
    }
  } while (Io.length);
}
j.__b = function(e) {
  re = null, ii && ii(e);
}, j.__ = function(e, t) {
  e && t.__k && t.__k.__m && (e.__m = t.__k.__m), ci && ci(e, t);
}, j.__r = function(e) {
  ai && ai(e), Xt = 0;
  var t = (re = e.__c).__H;
  t && (Lo == re ? re.__h = [] : (t.__h.some(Gt), t.__h.some(Ao), Xt = 0), t.__h = [], t.__.some(function(n) {
    n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
  })), Lo = re;
}, j.diffed = function(e) {
  si && si(e);
  var t = e.__c;
  t && t.__H && (t.__H.__h.length && pi(di.push(t)), t.__H.__.some(function(n) {
    n.u && (n.__H = n.u);
  })), Lo = re = null;
}, j.__c = function(e, t) {
  t.some(function(n) {
    try {
      n.__h.some(Gt), n.__h = n.__h.filter(function(o) {
        return !o.__ || Ao(o);
      });
    } catch (o) {
      n.__h = [function() {
        throw o;
      }];
    }
  }), li && li(e, t);
}, j.unmount = function(e) {
  ui && ui(e);
  var t, n, o = e.__c;
  o && o.__H && (o.__H.__.some(function(r) {
    try {
      if (r.__P && r.__c) {
        if (n === void 0) {
          for (n = e.__; n && (!n.__c || !n.__c.__P); ) n = n.__;
          n = n && n.__c;
        }
        r.__P = n, pi(Io.push(r));
      } else Gt(r);
    } catch (i) {
      t = i;
    }
  }), o.__H = void 0, t && j.__e(t, o.__v));
};
var fi = typeof requestAnimationFrame == "function";
function ms(e) {
  var t, n = function() {
    clearTimeout(o), fi && cancelAnimationFrame(t), setTimeout(e);
  }, o = setTimeout(n, 35);
  fi && (t = requestAnimationFrame(n));
}
function pi(e) {
  e != 1 && ri == j.requestAnimationFrame || ((ri = j.requestAnimationFrame) || ms)(ds);
}
function Gt(e) {
  var t = re, n = e.__c;
  typeof n == "function" && (e.__c = void 0, n()), re = t;
}
function Ao(e) {
  var t = re;
  e.__c = e.__(), re = t;
}
function Ho(e, t) {
  return !e || e.length != t.length || t.some(function(n, o) {
    return !fs(n, e[o]);
  });
}

// node_modules/@preact/signals-core/dist/signals-core.module.js
var hs = /* @__PURE__ */ Symbol.for("preact-signals");
function An() {
  if (Re > 1)
    Re--;
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
        if (n.u = void 0, n.f &= -3, !(8 & n.f) && hi(n)) try {
          n.c();
        } catch (r) {
          t || (e = r, t = !0);
        }
        n = o;
      }
    }
    if (Ln = 0, Re--, t) throw e;
  }
}
function Rn(e) {
  if (Re > 0) return e();
  Ko = ++vs, Re++;
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
var Qt = void 0, Re = 0, Ln = 0, vs = 0, Ko = 0, Vn = void 0, In = 0;
function mi(e) {
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
Y.prototype.brand = hs;
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
  return E(function() {
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
  var e = mi(this);
  return e !== void 0 && (e.i = this.i), this.v;
}, set: function(e) {
  if (e !== this.v) {
    if (Ln > 100) throw new Error("Cycle detected");
    (function(n) {
      Re !== 0 && Ln === 0 && n.l !== Ko && (n.l = Ko, Vn = { S: n, v: n.v, i: n.i, o: Vn });
    })(this), this.v = e, this.i++, In++, Re++;
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
function hi(e) {
  for (var t = e.s; t !== void 0; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return !0;
  return !1;
}
function vi(e) {
  for (var t = e.s; t !== void 0; t = t.n) {
    var n = t.S.n;
    if (n !== void 0 && (t.r = n), t.S.n = t, t.i = -1, t.n === void 0) {
      e.s = t;
      break;
    }
  }
}
function gi(e) {
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
  if (this.g = In, this.f |= 1, this.i > 0 && !hi(this))
    return this.f &= -2, !0;
  var e = H;
  try {
    vi(this), H = this;
    var t = this.x();
    (16 & this.f || this.v !== t || this.i === 0) && (this.v = t, this.f &= -17, this.i++);
  } catch (n) {
    this.v = n, this.f |= 16, this.i++;
  }
  return H = e, gi(this), this.f &= -2, !0;
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
  var e = mi(this);
  if (this.h(), e !== void 0 && (e.i = this.i), 16 & this.f) throw this.v;
  return this.v;
} });
function O(e, t) {
  return new nt(e, t);
}
function bi(e) {
  var t = e.j;
  if (e.j = void 0, typeof t == "function") {
    Re++;
    var n = H;
    H = void 0;
    try {
      t();
    } catch (o) {
      throw e.f &= -2, e.f |= 8, Oo(e), o;
    } finally {
      H = n, An();
    }
  }
}
function Oo(e) {
  for (var t = e.s; t !== void 0; t = t.n) t.S.U(t);
  e.x = void 0, e.s = void 0, bi(e);
}
function gs(e) {
  if (H !== this) throw new Error("Out-of-order effect");
  gi(this), H = e, this.f &= -2;
  try {
    8 & this.f && Oo(this);
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
  this.f |= 1, this.f &= -9, bi(this), vi(this), Re++;
  var e = H;
  return H = this, gs.bind(this, e);
};
bt.prototype.N = function() {
  2 & this.f || (this.f |= 2, this.u = Qt, Qt = this);
};
bt.prototype.d = function() {
  this.f |= 8, 1 & this.f || Oo(this);
};
bt.prototype.dispose = function() {
  this.d();
};
function E(e, t) {
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
var Do, Zt, Hn, bs = typeof window < "u" && !!window.__PREACT_SIGNALS_DEVTOOLS__, yi = [], _i = [];
E(function() {
  Do = this.N;
})();
function yt(e, t) {
  C[e] = t.bind(null, C[e] || function() {
  });
}
function Jt(e) {
  if (Hn) {
    var t = Hn;
    Hn = void 0, t();
  }
  Hn = e && e.S();
}
function wi(e) {
  var t = this, n = e.data, o = ot(n);
  o.name = "ReactiveDom", o.value = n;
  var r = $n(function() {
    for (var s = t, p = t.__v; p = p.__; ) if (p.__c) {
      p.__c.__$f |= 4;
      break;
    }
    var c = O(function() {
      var f = o.value.value;
      return f === 0 ? 0 : f === !0 ? "" : f || "";
    }), u = O(function() {
      return !Array.isArray(c.value) && !So(c.value);
    }), d = E(function() {
      if (this.N = ki, u.value) {
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
wi.displayName = "ReactiveTextNode";
Object.defineProperties(Y.prototype, { constructor: { configurable: !0, value: Yr(X, null).constructor }, type: { configurable: !0, value: wi }, props: { configurable: !0, get: function() {
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
      return E(function() {
        a = this;
      }, { name: i }), a.c = r, a;
    })(/* @__PURE__ */ (function(r) {
      return function() {
        var i;
        bs && ((i = this.y) == null || i.call(this)), r.__$f |= 1, r.setState({});
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
        c === void 0 ? (c = ys(n, p, u, r), i[p] = c) : c.o(u, r);
      }
    }
  }
  e(t);
});
function ys(e, t, n, o) {
  var r = t in e && e.ownerSVGElement === void 0, i = g(n);
  return { o: function(a, s) {
    i.value = a, o = s;
  }, d: E(function() {
    this.N = ki;
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
function ot(e, t) {
  return $n(function() {
    return g(e, t);
  }, []);
}
var _s = typeof requestAnimationFrame > "u" ? setTimeout : function(e) {
  var t = function() {
    clearTimeout(n), cancelAnimationFrame(o), e();
  }, n = setTimeout(t, 35), o = requestAnimationFrame(t);
}, ws = function(e) {
  queueMicrotask(function() {
    queueMicrotask(e);
  });
};
function ks() {
  Rn(function() {
    for (var e; e = yi.shift(); ) Do.call(e);
  });
}
function xs() {
  yi.push(this) === 1 && (C.requestAnimationFrame || _s)(ks);
}
function Ss() {
  Rn(function() {
    for (var e; e = _i.shift(); ) Do.call(e);
  });
}
function ki() {
  _i.push(this) === 1 && (C.requestAnimationFrame || ws)(Ss);
}
function xi(e, t) {
  var n = te(e);
  n.current = e;
  var o = Zt;
  Ce(function() {
    return E(function() {
      if (this.N = xs, !(o && 8 & o.__$f)) return n.current();
    }, t);
  }, []);
}

// src/prefs.ts
var Si = "lampyris-";
function ue(e, t) {
  let n = t;
  try {
    let r = localStorage.getItem(Si + e);
    r !== null && (n = JSON.parse(r));
  } catch {
  }
  let o = g(n);
  return E(() => {
    let r = JSON.stringify(o.value);
    try {
      localStorage.setItem(Si + e, r);
    } catch {
    }
  }), o;
}
var Fo = ue("theme", "dark"), No = ue("house-lights", 1), Kn = ue("hands", "default"), qo = ue("walking", "walk"), jo = ue("panels", !0), _t = ue("listing", "faders"), On = ue("travel", "square"), wt = ue("candles", "lx"), Uo = ue("single-keys", !0), Wo = ue("lamp-marks", !0), Ms = ue("maintenance", 1), je = ue("fine", !1), Bo = ue("fade", 1), Cs = typeof matchMedia == "function" && matchMedia("(pointer: coarse)").matches, ve = ue("look-only", Cs);

// src/store.ts
var Dn = /* @__PURE__ */ new Set(), kt = (e) => typeof e == "object" && e !== null && !Array.isArray(e);
function nn(e, t) {
  if (!kt(e) || !kt(t)) return t;
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
    Dn.add(this), this.show();
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
    this.own.size === 0 && Dn.delete(this), n && this.show();
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
function Mi(e) {
  let { name: t, group: n, lamps: o } = e;
  return `${t} ${n} ${o}`;
}
var Ee = class {
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
    for (let [o, r] of Object.entries(t ?? {})) n.set(Number(o), new en(r));
    this.entries = n, this.number();
  }
  patch(t) {
    let n = !1;
    for (let [o, r] of Object.entries(t)) {
      let i = Number(o), a = this.entries.get(i);
      r === null ? n = this.entries.delete(i) || n : a ? (Mi(a.shown.peek()) !== Mi(r) && this.order.value++, a.receive(r)) : (this.entries.set(i, new en(r)), n = !0);
    }
    n && this.number();
  }
  number() {
    this.ids.value = [...this.entries.keys()].sort((t, n) => t - n);
  }
}, x = new Ee(), D = new Ee(), ge = new Ee(), xt = new Ee(), St = new Ee(), Mt = new Ee(), Ct = new Ee(), Fn = new Ee(), tn = {
  lamps: x,
  groups: D,
  things: ge,
  materials: xt,
  views: St,
  looks: Mt,
  meters: Ct,
  grids: Fn
}, J = g(null), on = g([]), ke = g([]), rt = g({ undo: null, redo: null, steps: 0 }), it = g({ state: "clean", file: "" }), F = g({ you: !0, name: null }), Te = g(null), Nn = new en({
  ev: null,
  metered: !1,
  tone: "filmic",
  white: null,
  false_color: null
}), at = Nn.shown, zo = {
  scene: J,
  layers: on,
  solo: ke,
  history: rt,
  saved: it,
  editor: F,
  status: Te
};
function Ci(e) {
  Dn.clear();
  for (let [t, n] of Object.entries(tn)) n.whole(e[t]);
  for (let [t, n] of Object.entries(zo)) t in e && (n.value = e[t]);
  kt(e.display) && Nn.receive(e.display);
}
function Ei(e, t) {
  for (let [n, o] of Object.entries(e))
    n in tn ? tn[n].patch(o) : n === "display" ? Nn.receive(o) : n in zo && (zo[n].value = o);
  Et(t);
}
function Et(e) {
  for (let t of [...Dn]) t.release(e);
}
function Ti(e, t) {
  for (let [n, o] of Object.entries(e))
    if (n in tn && kt(o))
      for (let [r, i] of Object.entries(o)) {
        let a = tn[n].entry(Number(r));
        a && kt(i) && t(a, i);
      }
    else n === "display" && kt(o) && t(Nn, o);
}
var Go = (e, t) => Ti(e, (n, o) => n.keep(o, t)), qn = (e, t) => Ti(e, (n, o) => n.settle(o, t));
function He(e) {
  let t = D.get(e.group);
  return e.on && !e.parked && (t?.on ?? !0) ? e.level * (t?.level ?? 1) : 0;
}
var Pi = O(() => {
  let e = x.all();
  return e.length > 0 && e.every(([, t]) => He(t) === 0);
});
function Es(e, t) {
  let n = t.trim().toLowerCase();
  return e.all().filter(([, o]) => !n || o.name.toLowerCase().includes(n));
}

// src/say.ts
var st = g([]), Ts = 0;
function ae(e, t = "plain") {
  if (st.peek().find((r) => r.text === e)) return;
  let o = ++Ts;
  st.value = [...st.peek().slice(-2), { id: o, text: e, tone: t }], setTimeout(() => Xo(o), t === "warn" ? 8e3 : 4e3);
}
function Xo(e) {
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
}, $i = 0;
for (let e of ["input", "pointermove", "pointerdown", "keydown", "wheel"])
  addEventListener(e, (t) => $i = t.timeStamp, { capture: !0, passive: !0 });
function Li(e, t) {
  se.sent.push({ seq: e, what: t, at: performance.now(), input: $i }), se.sent.length > 1024 && se.sent.shift();
}
function Vi(e) {
  se.frame = e.frame, se.seqApplied = e.seq, se.firstDrawn ||= e.drawn, se.frames.push(e), se.frames.length > 1024 && se.frames.shift(), requestAnimationFrame(() => {
    let t = new MessageChannel();
    t.port1.onmessage = () => {
      e.painted = performance.now(), t.port1.close();
    }, t.port2.postMessage(0);
  });
}
window.__desk = se;

// src/wire.ts
var U = g("entering"), sn = g(0), pe = g("edit"), jn = g(null), Ke = g(0), Ii = () => null, Ai = (e) => {
  Ii = e;
}, Un = /* @__PURE__ */ new Map(), Ue = null, rn = 0, Yo = null, an = 0, Tt = "", Wn = !1;
function xe(e, t) {
  let n = Un.get(e) ?? /* @__PURE__ */ new Set();
  return Un.set(e, n.add(t)), () => n.delete(t);
}
function K(e) {
  return !Ue || Ue.readyState !== WebSocket.OPEN || U.peek() !== "open" ? 0 : (rn += 1, Ue.send(JSON.stringify({ ...e, seq: rn })), e.do !== "ack" && Li(rn, e.do), rn);
}
var Ps = 0, lt = /* @__PURE__ */ new Map();
function Se(e, t, n, o = () => {
}) {
  let r = ++Ps, i = xe("answer", (s) => {
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
function $s(e) {
  switch (e.is) {
    case "hello":
      if (an = 0, Yo !== null && e.build !== Yo) {
        U.value = "renewed", Ue?.close();
        return;
      }
      Yo = e.build, pe.value = e.role === "watch" ? "watch" : "edit", jn.value = e.you === void 0 ? null : String(e.you), Ke.value = 0, lt.clear(), U.value = "open";
      break;
    case "state":
      Ci(e.state ?? e);
      break;
    case "patch":
      (e.by == null || String(e.by) === jn.value) && Qo(e.seq), Ei(e.patch ?? {}, Ke.value);
      break;
    case "status":
      Te.value = e;
      break;
    case "refused":
      if (Qo(e.seq), Et(Ke.value), lt.has(e.seq)) {
        lt.get(e.seq)?.(e.why ?? ""), lt.delete(e.seq);
        return;
      }
      break;
    case "event":
      e.what === "bye" && (Wn = !0);
      break;
  }
  for (let t of [...Un.get(e.is) ?? []]) t(e);
}
function Qo(e) {
  typeof e == "number" && e > Ke.value && (Ke.value = e);
}
async function Ri() {
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
function Hi() {
  let e = location.protocol === "https:" ? "wss" : "ws", t = new WebSocket(`${e}://${location.host}/wire`);
  t.binaryType = "arraybuffer";
  let n = !1;
  Ue = t, Un.get("line")?.forEach((o) => o({ is: "line" })), t.onmessage = (o) => {
    if (t !== Ue) return;
    if (typeof o.data != "string") {
      let i = Ii(o.data);
      i && F.value.you && Qo(i.seq);
      return;
    }
    let r = JSON.parse(o.data);
    r.is === "hello" && (n = !0, rn = 0), $s(r);
  }, t.onclose = () => {
    t === Ue && (Ue = null, U.value !== "renewed" && Ls(n));
  };
}
async function Ls(e) {
  if (Et(1 / 0), !e && await Vs()) {
    let o = await Ri();
    if (o === "denied" || o === "in" && an > 4 && !Tt) {
      U.value = "denied";
      return;
    }
  }
  an += 1;
  let t = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
  an > 3 && t && (Wn = !0), U.value = Wn ? "ended" : "lost";
  let n = Math.min(5, an);
  for (let o = n; o > 0; o--)
    sn.value = o, await new Promise((r) => setTimeout(r, 1e3));
  sn.value = 0, Hi();
}
async function Vs() {
  try {
    return await fetch("/", { cache: "no-store" }), !0;
  } catch {
    return !1;
  }
}
async function Ki() {
  let e = location.hash.slice(1);
  if (e ? (Tt = e, sessionStorage.setItem("lampyris-key", Tt), window.history.replaceState(null, "", location.pathname + location.search)) : Tt = sessionStorage.getItem("lampyris-key") ?? "", se.entered = performance.now(), e && await Ri() === "denied") {
    U.value = "denied";
    return;
  }
  Hi();
}
xe("hello", () => Wn = !1);

// src/gesture.ts
var Pt = 0, Fi = /* @__PURE__ */ new Set(), Ni = (e) => {
  Fi.add(e);
}, ln = /* @__PURE__ */ new Set(), Bn = O(() => ve.value ? "The look-only lock is on." : pe.value === "watch" ? "You are watching. Ask for the pen to change things." : F.value.you ? null : `${F.value.name ?? "Somebody else"} has the pen. Take it to change things.`);
function zn() {
  return U.value !== "open" ? "There is no connection to the program: nothing was changed." : Bn.value;
}
var Oi = (e) => (e.length > 120 ? `${e.slice(0, 119)}…` : e).replace(/[\u0000-\u001f]/g, " "), We = class {
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
    this.state === "over" || !this.begin() || (Go(t, 1 / 0), this.touched = nn(this.touched, t), this.waiting = nn(this.waiting ?? {}, t), this.under <= Ke.peek() && this.flush());
  }
  /** Any other message that belongs to this step. */
  also(t) {
    this.state === "over" || !this.begin() || (this.flush(), this.last = K(t));
  }
  end(t) {
    this.state === "held" && (this.flush(), qn(this.touched, this.last), this.finish({ do: "end", ...t ? { label: Oi(t) } : {} })), this.state = "over";
  }
  cancel() {
    this.state === "held" && (this.waiting = null, qn(this.touched, 0), this.finish({ do: "cancel" }), Et(0)), this.state = "over";
  }
  /** The server has followed so far. */
  followed() {
    this.waiting && this.under <= Ke.peek() && this.flush();
  }
  /** The line is gone, and with it what was held. */
  drop() {
    this.state = "over", ln.delete(this), Pt = 0;
  }
  begin() {
    if (this.state === "held") return !0;
    let t = ie(zn);
    return t ? (ae(t, "warn"), this.state = "over", !1) : (this.state = "held", ln.add(this), Pt === 0 && Fi.forEach((n) => n()), Pt++ === 0 && (this.last = K({ do: "begin", label: Oi(this.label) })), !0);
  }
  flush() {
    this.waiting && (this.under = this.last = K({ do: "set", patch: this.waiting }), this.waiting = null);
  }
  finish(t) {
    ln.delete(this), Pt = Math.max(0, Pt - 1), Pt === 0 && K(t);
  }
};
function $e(e, t) {
  let n = new We(e);
  n.set(t), n.end();
}
function Is(e, t) {
  let n = new We(e);
  n.also(t), n.end();
}
function $t(e) {
  ie(() => U.value) === "open" && (Go({ display: e }, 1 / 0), qn({ display: e }, K({ do: "display", patch: e })));
}
var Pe = null;
function Jo(e, t, n) {
  Pe && Pe.key !== e && Di(), Pe ??= { key: e, gesture: new We(t), timer: 0 }, Pe.gesture.set(n), clearTimeout(Pe.timer), Pe.timer = window.setTimeout(Di, 700);
}
function Di() {
  Pe && (clearTimeout(Pe.timer), Pe.gesture.end(), Pe = null);
}
E(() => {
  Ke.value, ie(() => [...ln].forEach((e) => e.followed()));
});
E(() => {
  U.value !== "open" && [...ln].forEach((e) => e.drop());
});

// src/vec.ts
var I = (e, t) => [e[0] + t[0], e[1] + t[1], e[2] + t[2]], N = (e, t) => [e[0] - t[0], e[1] - t[1], e[2] - t[2]], S = (e, t) => [e[0] * t, e[1] * t, e[2] * t], q = (e, t) => e[0] * t[0] + e[1] * t[1] + e[2] * t[2], be = (e, t) => [
  e[1] * t[2] - e[2] * t[1],
  e[2] * t[0] - e[0] * t[2],
  e[0] * t[1] - e[1] * t[0]
], Oe = (e) => Math.hypot(e[0], e[1], e[2]), De = (e, t) => Oe(N(e, t)), As = (e, t, n) => I(S(e, 1 - n), S(t, n));
function Z(e, t = [0, 0, 1]) {
  let n = Oe(e);
  return n > 1e-12 ? S(e, 1 / n) : t;
}
function ut(e) {
  let t = Math.abs(e[0]) < 0.7 * Oe(e) ? [1, 0, 0] : [0, 1, 0];
  return Z(be(t, e));
}
function un(e, t, n) {
  let o = Math.cos(n), r = Math.sin(n);
  return I(I(S(e, o), S(be(t, e), r)), S(t, q(t, e) * (1 - o)));
}
function Lt([e, t]) {
  return Array.from({ length: 8 }, (n, o) => [
    o & 1 ? t[0] : e[0],
    o & 2 ? t[1] : e[1],
    o & 4 ? t[2] : e[2]
  ]);
}
var Be = ([e, t]) => As(e, t, 0.5);

// src/camera.ts
var Zo = Math.PI / 180, Gn = 89 * Zo;
function Vt(e, t, n) {
  let o = Z(N(e.target, e.eye), [0, 0, -1]), r = Z(be(o, e.up), ut(o)), i = be(r, o), a = e.height != null && e.height > 0, s = a ? e.height / n : 2 * Math.tan(e.fov * Zo * 0.5) / n;
  return { eye: e.eye, forward: o, side: r, up: i, width: t, height: n, pixel: s, parallel: a };
}
function cn(e, t) {
  let n = N(t, e.eye), o = q(n, e.forward), r = e.parallel ? e.pixel : e.pixel * o;
  return [e.width / 2 + q(n, e.side) / r, e.height / 2 - q(n, e.up) / r, o];
}
function Rs(e, t, n) {
  let o = (t - e.width / 2) * e.pixel, r = (e.height / 2 - n) * e.pixel, i = I(S(e.side, o), S(e.up, r));
  return e.parallel ? { origin: I(e.eye, i), direction: e.forward } : { origin: e.eye, direction: Z(I(e.forward, i)) };
}
function qi(e, t, n, o) {
  let r = N(e.target, e.eye), i = Math.max(Oe(r), 1e-3), a = Math.asin(Math.max(-1, Math.min(1, q(Z(r), t)))), s = N(r, S(t, q(r, t))), p = Z(Oe(s) > 1e-6 * i ? s : N(e.up, S(t, q(e.up, t))), ut(t)), c = Math.max(-Gn, Math.min(Gn, a + o)), u = un(p, t, n), d = I(S(u, Math.cos(c)), S(t, Math.sin(c)));
  return { ...e, up: t, target: I(e.eye, S(d, i)) };
}
function ji(e, t, n, o, r) {
  let i = N(e.target, e.eye), a = N(i, S(t, q(i, t))), s = Z(Oe(a) > 1e-6 ? a : e.up, ut(t)), p = Z(be(s, t)), c = I(I(S(s, n), S(p, o)), S(t, r));
  return ze(e, c);
}
function Ui(e, t, n, o, r) {
  let i = Z(N(e.target, e.eye)), a = Z(be(i, e.up), ut(i));
  return ze(e, I(I(S(i, n), S(a, o)), S(t, r)));
}
function ze(e, t) {
  return { ...e, eye: I(e.eye, t), target: I(e.target, t) };
}
function Wi(e, t, n, o, r) {
  let i = Z(N(e.target, e.eye)), a = Math.asin(Math.max(-1, Math.min(1, q(i, t)))), s = Math.max(-Gn, Math.min(Gn, a + r)), p = Z(be(i, t), Z(be(i, e.up), ut(i))), c = (u) => un(un(u, p, s - a), t, o);
  return {
    ...e,
    up: t,
    eye: I(n, c(N(e.eye, n))),
    target: I(n, c(N(e.target, n)))
  };
}
function Bi(e, t, n, o, r) {
  let i = t.parallel ? t.pixel : t.pixel * r;
  return ze(e, I(S(t.side, -n * i), S(t.up, o * i)));
}
function Xn(e, t, n, o, r) {
  let i = N(t, e.eye), a = Oe(i);
  if (a < 1e-9) return e;
  let s = a * (1 - n);
  return r ? s = Math.sign(s) * Math.max(Math.abs(s), 0.5 * Math.abs(1 - n)) : s > 0 && (s = Math.max(0, Math.min(s, a - o))), ze(e, S(i, s / a));
}
function Yn(e, t, n, o, r) {
  let i = Math.max(0.05, Math.min(1e5, (e.height ?? 1) * r)), a = (1 - i / (e.height ?? 1)) * t.pixel, s = I(
    S(t.side, (n - t.width / 2) * a),
    S(t.up, (t.height / 2 - o) * a)
  );
  return { ...ze(e, s), height: i };
}
function zi(e, t, n = 0.4) {
  let o = Be(t), r = Math.max(De(t[0], t[1]) / 2, 0.15), i = Z(N(e.eye, e.target));
  if (e.height) {
    let s = q(N(e.eye, o), i);
    return { ...e, eye: I(o, S(i, s)), target: o, height: r * 3 };
  }
  let a = Math.max(1.5 * r / Math.tan(e.fov * Zo * 0.5), n + r);
  return { ...e, eye: I(o, S(i, a)), target: o };
}
var Hs = ["plan", "ceiling", "north", "east", "south", "west"];
function Gi(e) {
  let t = Math.abs(e[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], n = Z(be(e, t));
  return { right: Z(be(n, e)), ahead: n };
}
function Xi(e, t, n, o) {
  let { right: r, ahead: i } = Gi(n), a = Be(t), s = (y) => Math.abs(q(N(t[1], t[0]), y)), c = {
    plan: { forward: S(n, -1), up: i, side: r, cut: 0.15 },
    ceiling: { forward: n, up: S(i, -1), side: r, cut: 0.35 },
    north: { forward: i, up: n, side: r, cut: 0.25 },
    south: { forward: S(i, -1), up: n, side: r, cut: 0.25 },
    east: { forward: r, up: n, side: i, cut: 0.25 },
    west: { forward: S(r, -1), up: n, side: i, cut: 0.25 }
  }[e], u = s(c.forward), d = 1, m = N(a, S(c.forward, u / 2 + d)), f = 1.08 * Math.max(s(c.up), s(c.side) / o, 0.1);
  return { eye: m, target: a, up: c.up, fov: 50, height: f, near: d + u * c.cut };
}
function fn(e, t) {
  let n = (r, i) => De(r, i) < 1e-4, o = (r, i) => Math.abs((r ?? -1) - (i ?? -1)) < 1e-4;
  return n(e.eye, t.eye) && n(e.target, t.target) && n(e.up, t.up) && o(e.fov, t.fov) && o(e.height, t.height) && o(e.near, t.near);
}

// src/frames.ts
var W = g(null), At = g(0), Yi = ["moving", "settled", "final"], Qi = 32, It = /* @__PURE__ */ new Map(), Le = null, er = null, tr = !1, ct = null;
function Ks(e) {
  if (e.byteLength < Qi) return null;
  let t = new DataView(e);
  return { head: {
    frame: t.getUint32(0, !0),
    seq: t.getUint32(4, !0),
    camera: t.getUint32(8, !0),
    width: t.getUint16(12, !0),
    height: t.getUint16(14, !0),
    kind: Yi[Math.min(t.getUint8(16), 2)],
    falseColor: (t.getUint8(18) & 1) === 1,
    batches: t.getUint32(20, !0),
    error: t.getFloat32(24, !0),
    light: t.getUint16(28, !0) / 10,
    encode: t.getUint16(30, !0) / 10
  }, mime: t.getUint8(17) === 1 ? "image/png" : "image/jpeg" };
}
function Os(e) {
  let t = Ks(e);
  return t ? (ct && K({ do: "ack", frame: ct.head.frame }), ct = { ...t, bytes: e, received: performance.now() }, tr || Ds(), t.head) : null;
}
async function Ds() {
  for (tr = !0; ct; ) {
    let { head: e, mime: t, bytes: n, received: o } = ct;
    ct = null;
    try {
      let r = await createImageBitmap(new Blob([new Uint8Array(n, Qi)], { type: t }));
      Fs(e, r, n.byteLength, o);
    } catch {
    }
    K({ do: "ack", frame: e.frame });
  }
  tr = !1;
}
function Fs(e, t, n, o) {
  let r = performance.now();
  Le && er && ((Le.width !== t.width || Le.height !== t.height) && (Le.width = t.width, Le.height = t.height), er.drawImage(t, 0, 0)), t.close();
  let i = It.get(e.camera) ?? W.peek()?.camera;
  i && (W.value = { head: e, camera: i }), Ns(), Vi({
    frame: e.frame,
    seq: e.seq,
    kind: Yi.indexOf(e.kind),
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
var Qn = [];
function Ns() {
  let e = performance.now();
  Qn = Qn.filter((t) => e - t < 1e3), Qn.push(e), At.value = Qn.length;
}
function nr(e) {
  Le = e, er = e?.getContext("2d", { alpha: !1 }) ?? null;
}
function Ji() {
  if (!Le || !W.peek()) return null;
  let e = document.createElement("canvas");
  return e.width = Le.width, e.height = Le.height, e.getContext("2d", { alpha: !1 })?.drawImage(Le, 0, 0), e;
}
Ai(Os);
xe("camera", (e) => {
  It.set(e.number, e);
  for (let t of It.keys()) {
    if (It.size <= 64) break;
    It.delete(t);
  }
});
xe("line", () => {
  It.clear(), ct = null;
});

// src/select.ts
var T = g(null), de = g(null), z = g(null), qs = g("move"), le = O(() => {
  let e = T.value;
  return e?.kind === "lamp" ? e.ids.filter((t) => x.has(t)) : e?.kind === "group" ? e.ids.flatMap((t) => D.get(t)?.lamps ?? []) : [];
});
function Ge(e, t, n = "only") {
  let o = T.peek();
  if (n === "only" || o?.kind !== e) {
    T.value = { kind: e, ids: [t] };
    return;
  }
  let r = o.ids.includes(t);
  if (r && n === "add") return;
  let i = r ? o.ids.filter((a) => a !== t) : [...o.ids, t];
  T.value = i.length ? { kind: e, ids: i } : null;
}
function Jn() {
  T.value = null;
}
function Zi(e, t, n) {
  let o = T.peek(), r = o?.kind === e ? t.indexOf(o.ids[o.ids.length - 1]) : -1;
  if (r < 0) return Ge(e, n);
  let i = t.indexOf(n), [a, s] = r < i ? [r, i] : [i, r], p = t.slice(a, s + 1), c = (o?.ids ?? []).filter((u) => !p.includes(u));
  T.value = { kind: e, ids: [...c, ...r < i ? p : p.reverse()] };
}
function js(e) {
  let t = T.peek(), n = t?.kind ?? "lamp", o = n === "lamp" ? x.ids.peek() : n === "thing" ? ge.ids.peek() : D.ids.peek();
  if (!o.length) return;
  let r = t ? o.indexOf(t.ids[t.ids.length - 1]) : e > 0 ? -1 : 0;
  Ge(n, o[(r + e + o.length) % o.length]);
}
function ea(e, t) {
  switch (e) {
    case "lamp":
      return x.get(t)?.name ?? `lamp ${t}`;
    case "group":
      return D.get(t)?.name ?? `group ${t}`;
    case "thing":
      return ge.get(t)?.name ?? `thing ${t}`;
    case "material":
      return xt.get(t)?.name ?? `material ${t}`;
    default:
      return `${e} ${t}`;
  }
}
function Zn(e) {
  return e.length === 1 ? ea("lamp", e[0]) : `${e.length} lamps`;
}
function ta(e, t) {
  let n = [];
  if (e?.lamp != null) {
    n.push({ kind: "lamp", ids: [e.lamp] });
    let i = x.get(e.lamp)?.group;
    i != null && (D.get(i)?.lamps.length ?? 0) > 1 && n.push({ kind: "group", ids: [i] });
  }
  if (e?.thing != null && n.push({ kind: "thing", ids: [e.thing] }), !n.length) {
    t === "only" && Jn();
    return;
  }
  if (t !== "only") return Ge(n[0].kind, n[0].ids[0], t);
  let o = T.peek(), r = n.findIndex((i) => o?.kind === i.kind && o.ids.length === 1 && o.ids[0] === i.ids[0]);
  T.value = n[(r + 1) % n.length];
}
var eo = g(null);

// src/navigate.ts
var Us = 1.6, ye = g(null), oa = O(() => pe.value === "edit" && F.value.you), Ve = O(() => J.value?.up ?? [0, 0, 1]), _e = g([640, 480]), Kt = g(null), ir = null, pn = null, or = !1, Xe = [], sr = [], ar = 0;
function Q(e, t = null) {
  let n = ye.peek();
  if (n && fn(n, e)) return;
  let o = performance.now();
  n && (o - ar > 1e3 || t) && (Xe.push(n), Xe.length > 100 && Xe.shift(), sr.length = 0), ar = o, ye.value = e, Kt.value = t;
}
var ne = () => ye.peek();
function Ws() {
  ra(Xe, sr);
}
function Bs() {
  ra(sr, Xe);
}
function ra(e, t) {
  let n = e.pop();
  if (!n) return;
  let o = ye.peek();
  o && t.push(o), ar = performance.now(), ye.value = n, Kt.value = null;
}
E(() => {
  !ye.value || U.value !== "open" || !oa.value || or || (or = !0, requestAnimationFrame(() => {
    or = !1;
    let t = ye.peek();
    if (!t || pn && fn(pn, t)) return;
    let { eye: n, target: o, up: r, fov: i, height: a, near: s } = t, p = { do: "camera", eye: n, target: o, up: r, fov: i };
    a && (p.height = a), s && (p.near = s), K(p) && (pn = t);
  }));
});
E(() => {
  let e = W.value;
  e && ie(() => {
    ye.peek() && oa.peek() || (pn = e.camera, ye.value = e.camera, ir ??= e.camera);
  });
});
xe("hello", () => pn = null);
function Ot(e, t) {
  let n = W.peek();
  if (!n) return null;
  let { head: o } = n, r = dn(o.width, o.height);
  return { frame: o.frame, x: (e - r.x) / r.scale, y: (t - r.y) / r.scale };
}
function dn(e, t) {
  let [n, o] = _e.peek(), r = Math.min(n / e, o / t);
  return { x: (n - e * r) / 2, y: (o - t * r) / 2, scale: r };
}
function ft(e = ye.peek()) {
  let [t, n] = _e.peek();
  return e ? Vt(e, t, n) : null;
}
var Ht = () => J.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]], Dt = () => Be(Ht());
function to(e, t) {
  let n = ne();
  n && Q(qi(n, Ve.peek(), e, t));
}
function no(e, t, n) {
  let o = ne();
  o && Q(Wi(o, Ve.peek(), e, t, n));
}
function Ft(e, t, n) {
  let o = ne(), r = ft();
  o && r && Q(Bi(o, r, e, t, n));
}
function ia(e, t, n) {
  let o = ne();
  if (o) {
    if (o.height) {
      let r = ft(o);
      r && Q(ze(o, I(S(r.side, t), S(r.up, e))));
      return;
    }
    qo.peek() === "fly" || n !== 0 ? Q(Ui(o, Ve.peek(), e, t, n)) : (Q(ji(o, Ve.peek(), e, t, 0)), zs());
  }
}
var Rt = !1, rr = !0, na = null;
function zs() {
  let e = ne();
  if (!e || Rt || !rr) return;
  let t = Ve.peek();
  Rt = !0;
  let n = Se("ray", { origin: e.eye, direction: S(t, -1) }, (o) => {
    Rt = !1, rr = !0;
    let r = ne();
    if (!o.hit || !r || r.height) return;
    na = q(o.point, t);
    let i = na + Us - q(r.eye, t);
    Math.abs(i) > 0.01 && Q(ze(r, S(t, i * 0.5)));
  }, () => {
    Rt = !1, rr = !1;
  });
  setTimeout(() => {
    Rt && n(), Rt = !1;
  }, 500);
}
function Gs() {
  let e = T.peek();
  if (!e) return null;
  let t = [], n = (i, a) => {
    i ? t.push(i) : a && t.push([a, a]);
  };
  for (let i of e.ids)
    if (e.kind === "lamp" && n(x.get(i)?.box, x.get(i)?.place?.position), e.kind === "thing" && n(ge.get(i)?.box), e.kind === "meter" && n(null, Ct.get(i)?.point), e.kind === "group")
      for (let a of D.get(i)?.lamps ?? []) n(x.get(a)?.box, x.get(a)?.place?.position);
  if (!t.length) return null;
  let o = t.flatMap(Lt), r = (i) => [0, 1, 2].map((a) => i(...o.map((s) => s[a])));
  return [r(Math.min), r(Math.max)];
}
function lr() {
  let e = ne(), t = Gs();
  e && t ? Q(zi(e, t), "selection") : ur();
}
function ur() {
  ir && Q(ir, "home");
}
function Xs(e) {
  let [t, n] = _e.peek();
  Q(Xi(e, Ht(), Ve.peek(), t / n), e);
}
function Ys() {
  for (let e = Xe.length - 1; e >= 0; e--)
    if (!Xe[e].height) return Q(Xe[e], "inside");
  ur();
}
var Qs = O(() => {
  let e = ye.value;
  if (!e?.height) return null;
  let t = Vt(e, 2, 2), n = Lt(Ht()).map((s) => q(N(s, e.eye), t.forward)), o = e.near ?? 0, r = q(t.forward, Ve.value), i = Math.min(...Lt(Ht()).map((s) => q(s, Ve.value))), a = Math.abs(r) > 0.99 ? q(e.eye, Ve.value) + r * o - i : null;
  return { value: o, most: Math.max(...n), height: a };
});
function Js(e) {
  let t = ne();
  t && (ye.value = { ...t, near: Math.max(0, e) });
}

// src/tools.ts
var cr = g("spot"), aa = () => {
}, Zs = (e) => {
  aa = e;
}, sa = (e) => aa(e);
function fr(e) {
  z.value = z.peek() === e ? null : e;
}
var oo = (e) => Math.max(-1, ...e.ids.peek()) + 1;
function pr(e) {
  return e.kind === "sky" || e.kind === "parallel" ? null : e.place?.position ?? (e.box ? Be(e.box) : null);
}

// src/actions.ts
var pt = g(null), Ie = g("lamps"), mr = g("");
function io(e) {
  let t = zn();
  t ? ae(t, "warn") : K(e);
}
var el = (e, t) => Object.fromEntries(e.map((n) => [n, t])), tl = {
  quantity: "illuminance",
  low: 1,
  high: 1e3,
  scale: "log",
  palette: "even",
  lines: !1
}, dr = tl, la = ({ quantity: e, low: t, high: n, scale: o, palette: r, lines: i }) => ({ quantity: e, low: t, high: n, scale: o, palette: r, lines: i }), nl = () => at.peek().false_color ?? dr;
function hr() {
  let e = at.peek().false_color;
  e && (dr = e), $t({ false_color: e ? null : la(dr) });
}
function ao(e) {
  let t = Math.round(((at.peek().ev ?? 0) + e / 3) * 30) / 30;
  $t({ ev: t });
}
function ol() {
  let e = ne();
  if (!e) return;
  let t = oo(St);
  $e("Store the view", { views: { [t]: { ...e, name: `View ${t + 1}` } } });
}
var rl = () => io({ do: "look", what: "store", name: `Look ${oo(Mt) + 1}` });
async function vr(e) {
  let t = !1;
  try {
    await navigator.clipboard.writeText(e), t = !0;
  } catch {
    let n = document.createElement("textarea");
    n.value = e, n.className = "spoken", document.body.append(n), n.select(), t = document.execCommand("copy"), n.remove();
  }
  ae(t ? "Copied." : `Copy it by hand: ${e}`);
}
var Nt = /* @__PURE__ */ new Map(), ro = null;
function il(e) {
  Nt = new Map(e.map((t) => [t.id, t])), ro && oe(ro), ro = null;
}
var al = () => [...Nt.values()], ua = (e) => Nt.get(e), gr = (e) => Nt.get(e)?.why?.() ?? null;
function oe(e) {
  let t = Nt.get(e);
  Nt.size || (ro = e);
  let n = t?.why?.();
  n ? ae(n, "warn") : t?.run();
}

// src/before.ts
var mn = g(null), me = g(null), sl = g(0.5);
function ll() {
  let e = W.peek(), t = Ji();
  e && t && (mn.value = { picture: t, camera: e.camera });
}
Ni(() => {
  me.peek() !== "wipe" && ll();
});
function ca() {
  let e = mn.peek(), t = W.peek();
  if (!e || !t) ae("Nothing has been changed yet.");
  else if (!fn(e.camera, t.camera)) ae("The picture before was taken from another place: go back there with Alt+←.", "warn");
  else return !0;
  return !1;
}
function hn(e) {
  e ? me.peek() === null && ca() && (me.value = "held") : me.peek() === "held" && (me.value = null);
}
function ul() {
  me.value = me.peek() === "wipe" ? null : ca() ? "wipe" : null;
}

// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var cl = /* @__PURE__ */ Symbol.for("pv"), fl = 0;
function l(e, t, n, o, r, i) {
  t || (t = {});
  var a, s, p = t;
  if ("ref" in p && typeof e != "function") for (s in p = {}, t) s == "ref" ? a = t[s] : p[s] = t[s];
  var c = { type: e, props: p, key: n, ref: a, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: cl, __v: --fl, __i: -1, __u: 0 };
  return (r || i) && (c.__source = r, c.__self = i), C.vnode && C.vnode(c), c;
}

// src/load.tsx
var pa = g(null), fa = !1, br = (e) => pa.value?.[e];
function ee({ part: e }) {
  let t = br(e);
  return t ? l(t, {}) : null;
}
function da() {
  E(() => {
    if (fa || !(W.value ?? T.value)) return;
    fa = !0;
    let e = "./gizmo.js";
    setTimeout(() => {
      import(e).then((t) => pa.value = t);
    }, 0);
  });
}

// src/units.ts
var so = 0.3048, ma = {
  level: { bare: 0.01, units: { "%": 0.01, x: 1, "×": 1 }, low: 0, high: 1e3, say: "a level such as 80 % or 450 lm" },
  flux: { bare: 1, units: { lm: 1, klm: 1e3 }, low: 0, high: 1e9, say: "a flux such as 450 lm" },
  kelvin: { bare: 1, units: { k: 1 }, low: 1e3, high: 25e3, say: "a colour temperature such as 2700 K" },
  angle: { bare: 1, units: { "°": 1, deg: 1, rad: 180 / Math.PI }, low: -36e3, high: 36e3, say: "an angle such as 30°" },
  length: {
    bare: 1,
    units: { m: 1, cm: 0.01, mm: 1e-3, km: 1e3, ft: so, "'": so, in: so / 12, '"': so / 12 },
    low: -1e6,
    high: 1e6,
    say: `a length such as 2.4 m, 75 cm or 8'2"`
  },
  lux: { bare: 1, units: { lx: 1, klx: 1e3, fc: 10.7639 }, low: 0, high: 1e9, say: "an illuminance such as 500 lx" },
  share: { bare: 1, units: { "%": 0.01 }, low: 0, high: 1, say: "a share from 0 to 1 or 0 to 100 %" },
  number: { bare: 1, units: {}, low: -1e9, high: 1e9, say: "a number" },
  ev: { bare: 1, units: { ev: 1, stop: 1, stops: 1 }, low: -30, high: 30, say: "an exposure such as 8.3" },
  seconds: { bare: 1, units: { s: 1, ms: 1e-3, min: 60 }, low: 0, high: 3600, say: "a time such as 2 s" }
}, pl = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;
function yr(e) {
  let t = pl.exec(e);
  if (!t) return null;
  let [n, o] = t[0].split("/").map(Number);
  return o === 0 ? null : { value: o === void 0 ? n : n / o, rest: e.slice(t[0].length).trimStart() };
}
function ha(e, t, n) {
  let o = e.trim(), r = 0, i = !0;
  for (; o; ) {
    let a = 1, s = /^[+-]\s*/.exec(o);
    s && !i && (a = o[0] === "-" ? -1 : 1, o = o.slice(s[0].length));
    let p = yr(o);
    if (!p) return null;
    let c = /^[a-zµ°%'"×]+/i.exec(p.rest)?.[0] ?? "", u = c === "" ? n : t.units[c.toLowerCase()];
    if (u === void 0) return null;
    r += a * p.value * u, o = p.rest.slice(c.length).trim(), i = !1;
  }
  return i ? null : r;
}
function va(e, t, n) {
  let o = ma[t], r = e.trim().replace(/,(?=\d)/g, ".").replace(/[\u2009\u202f\u00a0]/g, "").replace(/−/g, "-"), i = { why: `“${e.trim()}” is not ${o.say}` }, a = (_) => ({
    apply: (w) => Math.min(o.high, Math.max(o.low, _(w)))
  });
  if (!r) return { why: `Type ${o.say}` };
  let s = r.toLowerCase();
  if (t === "level" && s === "full") return a(() => 1);
  if (t === "level" && (s === "out" || s === "off")) return a(() => 0);
  let p = /^(.*?)\s*(?:stops?|ev)$/i.exec(r);
  if (p && t !== "ev") {
    let _ = yr(p[1].trim());
    return !_ || _.rest || !["level", "flux", "lux", "number"].includes(t) ? i : a((w) => w * 2 ** _.value);
  }
  let c = /^([*/×÷])\s*(.+)$/.exec(r);
  if (c) {
    let _ = yr(c[2]);
    if (!_) return i;
    let w = _.rest === "%" ? 0.01 : _.rest === "" ? 1 : NaN, M = _.value * w;
    return !Number.isFinite(M) || M === 0 && /[/÷]/.test(c[1]) ? i : a((b) => /[/÷]/.test(c[1]) ? b / M : b * M);
  }
  let d = t === "length" || t === "angle" || t === "ev" || t === "number" ? /^([+-])=\s*(.+)$/.exec(r) : /^([+-])=?\s*(.+)$/.exec(r), m = d ? d[2] : r, f = ha(m, o, o.bare);
  if (f === null && t === "level" && n) {
    let _ = ha(m, { ...ma.flux }, NaN);
    f = _ === null || Number.isNaN(_) ? null : _ / n;
  }
  if (f === null || !Number.isFinite(f)) return i;
  let y = f;
  return d ? a((_) => d[1] === "-" ? _ - y : _ + y) : y < o.low || y > o.high ? { why: `${e.trim()} is out of range: ${o.say}` } : a(() => y);
}
function B(e, t = 0) {
  if (!Number.isFinite(e)) return "–";
  let [n, o] = Math.abs(e).toFixed(t).split("."), r = n.length > 4 ? n.replace(/\B(?=(\d{3})+$)/g, " ") : n;
  return (e < 0 && Number(Math.abs(e).toFixed(t)) !== 0 ? "−" : "") + r + (o ? `.${o}` : "");
}
function Ye(e) {
  let t = Math.abs(e);
  return B(e, t >= 99.95 || t === 0 ? 0 : t >= 9.995 ? 1 : t >= 0.9995 ? 2 : 3);
}
function Ae(e) {
  let t = e * 100;
  return B(t, t >= 9.95 || t === 0 ? 0 : t >= 0.95 ? 1 : 2);
}
function vn(e, t) {
  switch (t) {
    case "level":
      return `${Ae(e)} %`;
    case "flux":
      return `${Ye(e)} lm`;
    case "kelvin":
      return `${B(e)} K`;
    case "angle":
      return `${B(e, 1)}°`;
    case "length":
      return `${B(e, 2)} m`;
    case "lux":
      return `${Ye(e)} lx`;
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
  let n = wt.value === "fc", o = n ? e / 10.7639 : e;
  return Ye(o) + (t ? n ? " fc" : " lx" : "");
}

// src/field.tsx
function gn(e) {
  let t = ot(null), n = ot(null), o = te(null), r = te(null), i = t.value ?? e.text ?? (e.value === null ? "mixed" : vn(e.value, e.quantity));
  Ce(() => {
    !e.open || !o.current || (t.value = e.open, o.current.focus(), o.current.setSelectionRange(e.open.length, e.open.length), e.opened?.());
  }, [e.open]);
  let a = () => {
    if (t.value === null) return;
    let d = va(t.value, e.quantity, e.flux);
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
function G({ name: e }) {
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
function _r({ id: e, label: t }) {
  let n = gr(e), o = ua(e);
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
var ga = {
  clean: "nothing changed",
  saved: "saved",
  waiting: "saving…",
  failed: "not saved"
};
function ba() {
  let e = at.value, t = rt.value.undo, n = rt.value.redo, o = it.value, r = e.metered;
  return l("header", { class: "bar", children: [
    l(qt, { id: "page-menu", label: l(G, { name: "menu" }), title: "Page", children: l(ee, { part: "PageItems" }) }),
    l("h1", { title: o.file || J.value?.file, children: [
      J.value?.name ?? "Lampyris",
      l("i", { class: `dot ${o.state}`, role: "img", "aria-label": ga[o.state], title: `${ga[o.state]}${o.file ? `: ${o.file}` : ""}` })
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
    l("button", { "aria-pressed": e.false_color !== null, onClick: hr, title: "False colour (B)", children: "False colour" }),
    l("button", { "aria-pressed": me.value === "wipe", "aria-disabled": mn.value === null, onClick: () => oe("wipe"), title: "Wipe between before and now (C); hold \\ to see before", children: "Compare" }),
    l("span", { class: "group exposure", role: "group", "aria-label": "Exposure", children: [
      l("button", { class: "icon", "aria-label": "Darker", title: "Darker by ⅓ (,)", onClick: () => ao(1), children: l(G, { name: "minus" }) }),
      l("label", { children: [
        l("span", { "aria-hidden": "true", children: "EV" }),
        l(gn, { label: "Exposure value", quantity: "ev", value: e.ev ?? 0, step: 1 / 3, set: (i) => $t({ ev: i(e.ev ?? 0) }) })
      ] }),
      l("button", { class: "icon", "aria-label": "Brighter", title: "Brighter by ⅓ (.)", onClick: () => ao(-1), children: l(G, { name: "plus" }) }),
      l("button", { class: "icon", "aria-label": "Meter once", title: `${r ? "As metered" : "Meter once"} (/); it stays locked`, onClick: () => K({ do: "expose" }), children: l(G, { name: r ? "lock" : "meter" }) })
    ] }),
    l(
      "button",
      {
        class: "icon look-lock",
        "aria-pressed": ve.value,
        "aria-label": "Look-only lock",
        title: "Look-only lock: no finger changes anything",
        onClick: () => ve.value = !ve.value,
        children: l(G, { name: ve.value ? "lock" : "unlock" })
      }
    ),
    pe.value === "edit" && l("button", { class: "wide", onClick: () => pt.value = "share", children: "Share" }),
    l("button", { class: "icon", "aria-label": "All keys", title: "All keys (?)", onClick: () => pt.value = "help", children: l(G, { name: "help" }) }),
    l("button", { class: "icon", "aria-label": "Command palette", title: "Command palette (Ctrl+K)", onClick: () => pt.value = "palette", children: l(G, { name: "search" }) }),
    l(
      "button",
      {
        class: "icon narrow",
        "aria-label": Ie.value === "inspector" ? "Lamps" : "Inspector",
        title: Ie.value === "inspector" ? "Lamps" : "Inspector",
        onClick: () => Ie.value = Ie.value === "inspector" ? "lamps" : "inspector",
        children: l(G, { name: Ie.value === "inspector" ? "lamps" : "sliders" })
      }
    )
  ] });
}

// src/highlight.ts
function lo(e) {
  ke.value = e, K({ do: "solo", lamps: e });
}
function wr(e) {
  let t = ke.peek(), n = e.every((o) => t.includes(o));
  lo(n ? t.filter((o) => !e.includes(o)) : [...t, ...e.filter((o) => !t.includes(o))]);
}
var dl = () => wr(le.peek()), kr = () => lo([]), bn = null;
function uo(e) {
  e && bn === null && le.peek().length ? (bn = ke.peek(), lo(le.peek())) : !e && bn !== null && (lo(bn), bn = null);
}

// src/lights.ts
var Qe = g(null), xr = () => {
}, _a = () => {
};
function co(e, t, n) {
  fo(), Qe.value = { x: e, y: t, hit: n, lux: n.lux, lamps: [], done: !1 }, ya(n);
  let o = !0, r = 0;
  _a = E(() => {
    for (let [, i] of x.all()) He(i);
    if (o) {
      o = !1;
      return;
    }
    clearTimeout(r), r = window.setTimeout(() => {
      let i = ie(() => Qe.value);
      i && ya(i.hit);
    }, 250);
  });
}
function ya(e) {
  xr(), xr = Se("light", { point: e.point, normal: e.normal }, (t) => {
    let n = Qe.peek();
    n && (Qe.value = {
      ...n,
      lux: t.lux ?? n.lux,
      lamps: t.lamps ?? n.lamps,
      done: t.done !== !1
    });
  });
}
function fo() {
  xr(), _a(), Qe.value = null;
}

// src/keys.ts
var Ea = g("W A S D"), Sr = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyA: [0, -1, 0],
  KeyD: [0, 1, 0],
  KeyQ: [0, 0, -1],
  KeyE: [0, 0, 1]
}, ml = 1.8, jt = /* @__PURE__ */ new Set(), po = !1, mo = 1, Mr = !1, Cr = 0;
function Ta(e) {
  let t = Math.min(0.1, Math.max(0, (e - Cr) / 1e3));
  if (Cr = e, !jt.size) {
    Mr = !1;
    return;
  }
  let [n, o, r] = [0, 0, 0];
  for (let s of jt) {
    let [p, c, u] = Sr[s];
    n += p, o += c, r += u;
  }
  let i = Math.max(1, De(...Ht()) / 12), a = ml * t * mo * Math.min(i, 6);
  (n || o || r) && ia(n * a, o * a, r * a), requestAnimationFrame(Ta);
}
function yn(e) {
  jt.add(e), !Mr && (Mr = !0, Cr = performance.now(), requestAnimationFrame(Ta));
}
var hl = (e) => e instanceof HTMLElement && (e.isContentEditable || e.matches("input, textarea, select") && !e.matches("[type=range], [type=checkbox], [type=radio]"));
function wa() {
  let e = document.activeElement;
  return e === null || e === document.body || e.id === "view";
}
var vl = {
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
}, ka = {
  b: "quantity",
  o: "park",
  i: "unsolo",
  l: "from-lamp",
  g: "grid",
  t: "aim-here"
}, xa = { Comma: "darker", Period: "brighter", Slash: "expose" }, Sa = {
  Digit1: "preset-plan",
  Digit2: "preset-ceiling",
  Digit3: "preset-north",
  Digit4: "preset-east",
  Digit5: "preset-south",
  Digit6: "preset-west",
  Digit0: "inside"
};
function gl(e) {
  let t = e.key.toLowerCase();
  return t === "z" ? e.shiftKey ? "redo" : "undo" : t === "y" ? "redo" : t === "k" ? "palette" : t === "s" ? e.shiftKey ? "picture" : "save" : t === "d" ? "duplicate" : t === "a" ? "all-lamps" : t === "enter" ? "look-store" : null;
}
function bl() {
  z.peek() ? z.value = null : Qe.peek() ? fo() : me.peek() ? me.value = null : T.peek() ? Jn() : document.activeElement?.id === "view" && document.querySelector('.bar button, .bar [tabindex="0"]')?.focus();
}
function Ma(e) {
  let [t, n] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
  return !t && !n ? !1 : (e.ctrlKey || ne()?.height ? Ft(-t * 24, n * 24, 3) : e.shiftKey ? no(Dt(), -t * 0.05, n * 0.05) : to(-t * 0.06, n * 0.06), !0);
}
function Ca(e) {
  let t = ne(), n = ft();
  !t || !n || (t.height ? Q(Yn(t, n, n.width / 2, n.height / 2, e)) : Q(Xn(t, t.target, e, 0.3, !0)));
}
function yl(e) {
  if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
  let t = e.ctrlKey || e.metaKey;
  if (e.key === "Escape") return bl();
  if (hl(e.target)) {
    t && e.key.toLowerCase() === "k" && Fe(e, "palette");
    return;
  }
  if (t && !e.altKey) {
    if (wa() && Ma(e)) return e.preventDefault();
    let i = gl(e);
    i && Fe(e, i);
    return;
  }
  if (e.altKey) {
    let i = /^Digit(\d)$/.exec(e.code)?.[1];
    if (e.key === "ArrowLeft") return Fe(e, "back");
    if (e.key === "ArrowRight") return Fe(e, "forth");
    if (i === "0") return Fe(e, "store-view");
    if (i) {
      e.preventDefault();
      let a = St.all()[Number(i) - 1];
      a && Q(a[1], a[1].name ?? "view");
      return;
    }
    if (e.code === "KeyH" && Fe(e, "unhide"), !(e.code in Sr)) return;
  }
  let n = wa();
  if (n && Ma(e)) return e.preventDefault();
  if (n && e.code in Sr)
    return mo = e.shiftKey ? 4 : e.altKey ? 0.25 : 1, yn(e.code), e.preventDefault();
  if (n && (e.key === "+" || e.key === "=")) return Ca(0.85);
  if (n && (e.key === "-" || e.key === "_")) return Ca(1 / 0.85);
  if (!Uo.peek()) return;
  if (e.shiftKey && Sa[e.code]) return Fe(e, Sa[e.code]);
  if (po && /^\d$/.test(e.key)) {
    e.preventDefault(), po = !1;
    let i = Mt.ids.peek()[Number(e.key) - 1];
    i !== void 0 && io({ do: "look", id: i, what: "recall", seconds: Bo.peek() });
    return;
  }
  if (po = e.key.toLowerCase() === "j", po) return ae("Recall a look: now its digit.");
  if (!e.shiftKey && /^\d$/.test(e.key) && le.peek().length) {
    e.preventDefault(), mr.value = e.key;
    return;
  }
  if (!e.shiftKey && e.key !== "?" && xa[e.code]) return Fe(e, xa[e.code]);
  if (e.key === "\\") return void (e.repeat || hn(!0));
  let o = e.key.toLowerCase();
  if (o === "l" && !e.shiftKey) return void (e.repeat || oe("highlight"));
  if (o === "p" && e.shiftKey) return _l();
  let r = e.shiftKey && ka[o] ? ka[o] : vl[o];
  r && !(e.target instanceof HTMLButtonElement && o === "enter") && Fe(e, r);
}
function _l() {
  let [e, t] = _e.peek(), n = Ot(e / 2, t / 2);
  n && Se("point", n, (o) => o.hit && co(e / 2, t / 2, o));
}
function Fe(e, t) {
  e.preventDefault(), oe(t);
}
function wl(e) {
  jt.delete(e.code), e.key === "\\" && hn(!1), e.key.toLowerCase() === "l" && uo(!1), e.key === "Shift" && (mo = 1);
}
function Pa() {
  addEventListener("keydown", yl), addEventListener("keyup", wl), addEventListener("blur", () => {
    jt.clear(), uo(!1), hn(!1);
  }), navigator.keyboard?.getLayoutMap().then((t) => {
    Ea.value = ["KeyW", "KeyA", "KeyS", "KeyD"].map((n) => (t.get(n) ?? n.slice(3)).toUpperCase()).join(" ");
  }).catch(() => {
  });
}
function kl(e, t) {
  for (let n of ["KeyW", "KeyS", "KeyA", "KeyD"]) jt.delete(n);
  mo = Math.min(1, Math.hypot(e, t)), e > 0.2 && yn("KeyW"), e < -0.2 && yn("KeyS"), t < -0.2 && yn("KeyA"), t > 0.2 && yn("KeyD");
}

// src/levels.ts
var Er = (e) => Math.min(1, On.value === "square" ? Math.sqrt(Math.max(e, 0)) : e), Tr = (e) => {
  let t = On.peek() === "square" ? e * e : e;
  return Math.round(t * 1e3) / 1e3;
}, xl = (e) => (e.kind === "lamp" ? x.get(e.id) : D.get(e.id))?.level ?? 0, ho = (e) => (e.kind === "lamp" ? x.get(e.id) : D.get(e.id))?.name ?? "";
function Pr(e) {
  let t = le.peek();
  return e.kind === "lamp" && T.peek()?.kind === "lamp" && t.length > 1 && t.includes(e.id) ? t : [e.id];
}
function $a(e, t, n) {
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
    this.was = this.now = xl(t), this.from = t.kind === "lamp" ? new Map(Pr(t).map((n) => [n, x.get(n)?.level ?? 0])) : /* @__PURE__ */ new Map(), this.gesture = new We(`${ho(t)} level`);
  }
  strip;
  gesture;
  from;
  was;
  now;
  to(t) {
    this.now = t, this.gesture.set($a(this.strip, t, this.from));
  }
  end() {
    let t = this.from.size > 1 ? Zn([...this.from.keys()]) : ho(this.strip);
    this.gesture.end(`${t} ${Ae(this.was)} → ${Ae(this.now)} %`);
  }
  cancel() {
    this.gesture.cancel();
  }
};
function vo(e, t) {
  let n = new Map(Pr(e).map((o) => [o, x.get(o)?.level ?? 0]));
  Jo(`level ${e.kind} ${e.id}`, `${ho(e)} level`, $a(e, t, n));
}
function $r(e, t) {
  if (!e.length) return;
  let n = Object.fromEntries(e.map((r) => {
    let i = x.get(r);
    return [r, { level: t(i?.level ?? 0, i?.flux ?? 1) }];
  })), o = e.length === 1 ? ` ${Ae(x.get(e[0])?.level ?? 0)} → ${Ae(n[e[0]].level)} %` : " level";
  $e(`${Zn(e)}${o}`, { lamps: n });
}
function Lr(e, t) {
  let n = t(D.get(e)?.level ?? 0);
  $e(`${D.get(e)?.name ?? "Group"} ${Ae(n)} %`, { groups: { [e]: { level: n } } });
}
function Vr(e, t) {
  let n = `${ho(e)} ${t ? "on" : "off"}`;
  e.kind === "group" ? $e(n, { groups: { [e.id]: { on: t } } }) : $e(n, { lamps: Object.fromEntries(Pr(e).map((o) => [o, { on: t }])) });
}

// src/swatch.ts
var Sl = (e) => e <= 31308e-7 ? 12.92 * e : 1.055 * e ** 0.4166666666666667 - 0.055, Ml = (e) => e <= 0.04045 ? e / 12.92 : ((e + 0.055) / 1.055) ** 2.4, Cl = (e) => Math.round(255 * Sl(Math.max(0, Math.min(1, e))));
function Ir(e) {
  let t = Math.max(...e, 1e-6);
  return La(e.map((n) => n / t));
}
function La(e) {
  return `#${e.map((t) => Cl(t).toString(16).padStart(2, "0")).join("")}`;
}
function El(e) {
  let t = (n) => Ml(parseInt(e.slice(1 + 2 * n, 3 + 2 * n), 16) / 255);
  return [t(0), t(1), t(2)];
}
var Tl = (e) => 1e6 / e;

// src/range.tsx
var Va = -1e9;
addEventListener("scroll", () => Va = performance.now(), { capture: !0, passive: !0 });
var Ut = (e) => Math.max(0, Math.min(1, e));
function Ar(e) {
  let t = te(null), n = te(null), o = e.notch ?? 0.01, r = (c) => {
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
    if (performance.now() - Va < 400 || c.ctrlKey) return;
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
function Ia(e) {
  let t = e.color;
  return t.mode === "kelvin" ? `${B(t.kelvin)} K` : t.mode === "rgb" ? "RGB" : t.mode === "xy" ? "x y" : "file";
}
var Rr = (e) => e.free ? "re-mix: level and colour cost no ray" : "re-trace: its light is traced anew";
function Aa({ row: e, index: t, count: n }) {
  let o = te(null), r = { kind: e.kind, id: e.id }, i = e.kind === "lamp" ? x.get(e.id) : void 0, a = e.kind === "group" ? D.get(e.id) : void 0, s = i ?? a;
  if (!s) return null;
  let p = a?.lamps ?? [e.id], c = i ? i.flux : p.reduce((b, k) => b + (x.get(k)?.flux ?? 0) * (x.get(k)?.level ?? 0), 0), u = i ? i.flux * He(i) : p.reduce((b, k) => b + (x.get(k)?.flux ?? 0) * He(x.get(k)), 0), d = T.value?.kind === e.kind && T.value.ids.includes(e.id), m = p.length > 0 && p.every((b) => ke.value.includes(b)), f = ke.value.length > 0 && !p.some((b) => ke.value.includes(b)), y = de.value?.kind === e.kind && de.value.id === e.id, _ = `${d ? "selected" : ""} ${s.on && !i?.parked ? "" : "off"} ${f ? "muted" : ""} ${y ? "under" : ""}`, w = Bn.value, M = {
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
      class: `fader-row depth-${e.depth} ${e.kind} ${_}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => de.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => de.value = null,
      children: [
        l("button", { class: "icon power", "aria-pressed": s.on, disabled: w !== null, "aria-label": `${s.name} on`, title: w ?? (s.on ? "On (O)" : "Off (O)"), onClick: () => Vr(r, !s.on), children: l(G, { name: "power" }) }),
        l("div", { class: "top", children: [
          a && l("button", { class: "icon fold", "aria-expanded": !mt.value.has(e.id), "aria-label": `Members of ${s.name}`, onClick: () => Ra(e.id), children: l(G, { name: mt.value.has(e.id) ? "right" : "down" }) }),
          l("button", { class: "row-name", "aria-pressed": d, title: i ? `${i.name}: ${Rr(i)}` : s.name, onClick: (b) => Hr(b, e.kind, e.id), children: [
            l("span", { children: s.name }),
            a && l("small", { children: p.length }),
            i?.parked && l("small", { children: "parked" }),
            i && !i.free && l("small", { class: "traced", title: Rr(i), children: [
              "↻",
              l("span", { class: "spoken", children: "re-trace" })
            ] })
          ] }),
          i && l("span", { class: "tint", children: [
            l("i", { class: "swatch", style: { background: Ir(i.swatch) } }),
            Ia(i)
          ] }),
          l("button", { class: "icon solo", "aria-pressed": m, "aria-label": `Solo ${s.name}`, title: "Solo (I)", onClick: () => wr(p), children: l(G, { name: "solo" }) })
        ] }),
        l("div", { class: "bottom", children: [
          l(
            Ar,
            {
              label: `${s.name} level`,
              class: "level",
              value: Er(s.level),
              text: `${Ae(s.level)} %, ${Ye(u)} lumen`,
              notch: 0.01,
              disabled: w !== null,
              on: (b) => {
                let k = Tr(b);
                o.current ? o.current.to(k) : vo(r, k);
              },
              reset: () => vo(r, 1),
              ...M
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
              set: (b) => i ? $r(d && le.peek().length > 1 ? le.peek() : [e.id], b) : Lr(e.id, b)
            }
          ),
          l("span", { class: "lumens", children: vn(u, "flux") })
        ] })
      ]
    }
  );
}

// src/virtual.tsx
var Ha = 4;
function Kr({ count: e, height: t, row: n, label: o, show: r, role: i = "list" }) {
  let a = te(null), s = ot(0), p = ot(600);
  Ce(() => {
    let d = a.current, m = new ResizeObserver(() => p.value = d.clientHeight);
    return m.observe(d), () => m.disconnect();
  }, []), Ce(() => {
    let d = a.current;
    if (!d || r === void 0 || r < 0) return;
    let m = r * t;
    (m < d.scrollTop || m + t > d.scrollTop + d.clientHeight) && (d.scrollTop = Math.max(0, m - d.clientHeight / 2));
  }, [r, t]);
  let c = Math.max(0, Math.floor(s.value / t) - Ha), u = Math.min(e, Math.ceil((s.value + p.value) / t) + Ha);
  return l("div", { class: "virtual", ref: a, tabIndex: e ? void 0 : -1, onScroll: (d) => s.value = d.currentTarget.scrollTop, children: l("div", { class: "all", role: i, "aria-label": o, style: { height: `${e * t}px` }, children: l("div", { class: "rows", role: "presentation", style: { transform: `translateY(${c * t}px)` }, children: Array.from({ length: Math.max(0, u - c) }, (d, m) => n(c + m)) }) }) });
}

// src/lamps.tsx
var go = g(""), mt = g(/* @__PURE__ */ new Set()), bo = g("group"), Oa = O(() => {
  let e = go.value.trim().toLowerCase(), t = x.listed(), n = D.listed(), o = new Map(n.map(([s, p]) => [s, p.name])), r = new Map(t.filter(([, s]) => !e || `${s.name} ${s.kind} ${o.get(s.group ?? -1) ?? ""}`.toLowerCase().includes(e)));
  if (bo.value !== "group" && _t.value === "sheet") {
    let s = bo.value, p = [...r];
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
}), Ka = !1;
D.ids.subscribe((e) => {
  Ka || !e.length || (Ka = !0, x.ids.peek().length > 40 && (mt.value = new Set(e.filter((t) => (D.get(t)?.lamps.length ?? 0) > 1))));
});
function Ra(e) {
  let t = new Set(mt.peek());
  t.delete(e) || t.add(e), mt.value = t;
}
function Hr(e, t, n) {
  e.shiftKey ? Zi(t, Oa.peek().filter((o) => o.kind === t).map((o) => o.id), n) : Ge(t, n, e.ctrlKey || e.metaKey ? "toggle" : "only");
}
function Pl(e) {
  let t = { ArrowDown: 1, ArrowUp: -1 }[e.key], n = e.target;
  if (!t || !n.matches(".row-name")) return;
  e.preventDefault();
  let o = [...e.currentTarget.querySelectorAll(".row-name")];
  o[o.indexOf(n) + t]?.focus();
}
var $l = ["add-spot", "add-point", "add-disc", "add-sphere"];
function Da() {
  let e = Oa.value, t = T.value?.ids[T.value.ids.length - 1], n = e.findIndex((i) => i.kind === T.value?.kind && i.id === t), o = matchMedia("(pointer: coarse)").matches, r = _t.value === "sheet";
  return l("section", { class: "panel lamps", "aria-label": "Lamps", onKeyDown: Pl, children: [
    l("header", { class: "panel-head", children: [
      l("h2", { children: [
        "Lamps ",
        l("small", { children: B(x.ids.value.length) })
      ] }),
      l("span", { class: "gap" }),
      l("div", { class: "segments", role: "group", "aria-label": "Listing", children: [
        l("button", { "aria-pressed": !r, onClick: () => _t.value = "faders", children: "Faders" }),
        l("button", { "aria-pressed": r, onClick: () => _t.value = "sheet", children: "Sheet" })
      ] })
    ] }),
    l("div", { class: "panel-tools", children: [
      l("span", { class: "field filter", children: l(
        "input",
        {
          type: "text",
          "aria-label": "Filter lamps",
          placeholder: "Filter",
          value: go.value,
          onInput: (i) => go.value = i.currentTarget.value,
          onKeyDown: (i) => {
            i.key === "Escape" && (go.value = "", i.stopPropagation());
          }
        }
      ) }),
      r && l("select", { "aria-label": "Order", value: bo.value, onChange: (i) => bo.value = i.currentTarget.value, children: [
        l("option", { value: "group", children: "by group" }),
        l("option", { value: "name", children: "by name" }),
        l("option", { value: "flux", children: "by flux" }),
        l("option", { value: "level", children: "by level" })
      ] }),
      l(qt, { id: "add-menu", label: "Add", title: "Add a lamp", children: [
        $l.map((i) => l(_r, { id: i }, i)),
        l("button", { class: "item", "aria-disabled": "true", title: "Photometric files come with a later version", children: [
          l("span", { children: "IES or LDT file…" }),
          l("kbd", { children: "later" })
        ] })
      ] })
    ] }),
    r && l(ee, { part: "SheetHead" }),
    l(
      Kr,
      {
        label: "Lamps and groups",
        count: e.length,
        height: r ? o ? 44 : 28 : o ? 84 : 54,
        show: n,
        row: (i) => {
          let a = e[i], s = r ? br("SheetRow") : Aa;
          return s && l(s, { row: a, index: i, count: e.length }, `${a.kind}${a.id}`);
        }
      }
    ),
    le.value.length > 1 && l("p", { class: "several", children: [
      le.value.length,
      " selected; a fader moves them in proportion",
      l("button", { onClick: () => oe("none"), children: "None" })
    ] }),
    !e.length && x.ids.value.length > 0 && l("p", { class: "quiet empty", children: "No lamp is called so." })
  ] });
}

// src/states.ts
var wn = g(null), Je = g([]), kn = g(null), Dr = g(null), Or = O(() => Te.value?.stage ?? "loading"), Ll = O(() => {
  let e = Te.value?.fps ?? 0;
  return Or.value === "moving" && e > 6 && At.value < 0.4 * e && At.value < 5;
}), Wt = O(() => {
  switch (U.value) {
    case "entering":
      return "starting";
    case "open":
      break;
    default:
      return U.value;
  }
  return !J.value || !W.value ? "loading" : it.value.state === "failed" ? "unsaved" : wn.value !== null ? "broken" : kn.value !== null && !F.value.you ? "control-lost" : pe.value === "watch" || !F.value.you ? "watching" : x.ids.value.length === 0 ? "no-lamps" : Pi.value ? "all-off" : Ll.value ? "slow" : Or.value === "loading" ? "first" : Or.value;
});
xe("event", (e) => {
  switch (e.what) {
    case "reloaded": {
      wn.value = null, Je.value = e.lost ?? [];
      let t = e.kept ?? 0;
      ae(`The scene was read again: ${t} edits kept${Je.value.length ? `, ${Je.value.length} no longer find what they changed` : ""}.`);
      break;
    }
    case "broken":
      wn.value = e.why ?? "The scene file cannot be read.";
      break;
    case "taken":
      kn.value = e.by ?? F.peek().name ?? "somebody else";
      break;
    case "loading":
      Dr.value = e;
      break;
  }
});
xe("refused", (e) => ae(e.why ?? "That could not be done.", "warn"));
E(() => {
  F.value.you && (kn.value = null);
});

// src/probe.ts
var yo = g(null);
function _o(e, t, n) {
  let o = Ot(e, t);
  if (!o) return n(null);
  Se("point", o, (r) => n(r.hit ? r : null));
}
function Fa(e) {
  if (!e) return "";
  let t = [], n = x.get(e.lamp)?.name, o = ge.get(e.thing)?.name, r = xt.get(e.material)?.name;
  if (n && t.push(n), o && o !== n && t.push(o), r && r !== o && t.push(r), e.lux && t.push(`${dt(e.lux[0])} ±${dt(e.lux[1], !1)}`), e.luminance) {
    let i = e.luminance[0] * (wt.value === "fc" ? 0.2919 : 1);
    t.push(`${Ye(i)} ${wt.value === "fc" ? "fL" : "cd/m²"}`);
  }
  return t.join(" · ");
}

// src/status.tsx
var Na = O(() => {
  W.value;
  let e = [];
  for (let t of se.sent.slice(-24)) {
    if (t.what !== "set" && t.what !== "camera") continue;
    let n = se.frames.find((o) => o.seq >= t.seq && o.painted);
    n && n.painted > t.at && e.push(n.painted - (t.input || t.at));
  }
  return e.sort((t, n) => t - n), e.length ? e[e.length >> 1] : null;
});
function Vl() {
  let e = Te.value;
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
function qa() {
  let e = Te.value, t = W.value?.head, n = on.value.filter((r) => r.batches < r.of && !r.held).length, o = e?.stage === "refining" && e.good_in ? Math.max(0.02, 1 / (1 + e.good_in)) : e?.stage === "good" || e?.stage === "done" ? 1 : 0.02;
  return l("footer", { class: "status", "aria-label": "Status", children: [
    l("span", { class: `quality ${e?.stage ?? ""}`, children: [
      l("i", { class: "thin", "aria-hidden": "true", children: l("b", { style: { width: `${o * 100}%` } }) }),
      Vl()
    ] }),
    l("span", { children: [
      B(t?.batches ?? e?.batches ?? 0),
      " batches"
    ] }),
    l("span", { children: U.value === "open" ? `${B(At.value)} fps` : "no line" }),
    Na.value !== null && l("span", { title: "From the hand to the paint, median", children: [
      B(Na.value),
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
    l("span", { class: "probe", "aria-live": "off", children: Fa(yo.value) }),
    l("span", { class: "gap" }),
    l("span", { children: F.value.you ? "editing: you" : `editing: ${F.value.name ?? "somebody else"}` }),
    l("span", { class: "spoken", children: [
      jn.value ?? "",
      " ",
      Wt.value
    ] })
  ] });
}

// src/pointer.ts
var Il = 4, ja = 35e-4, Al = 0.15;
function Rl(e, t, n) {
  return e === "maya" && n.alt ? ["orbit", "pan", "dolly"][t] ?? "none" : e === "blender" && t === 1 ? n.shift ? "pan" : n.ctrl ? "dolly" : "orbit" : t === 1 ? n.shift ? "pan" : "orbit" : t === 2 ? "look" : t === 0 ? n.alt ? "orbit" : n.space ? "pan" : n.shift || n.ctrl ? "none" : "look" : "none";
}
function Ua(e, t) {
  let n = /* @__PURE__ */ new Map(), o = Dt(), r = 3, i = !1, a = 0, s = 0, p = 0, c = null, u = (h) => {
    let v = e.getBoundingClientRect();
    return [h.clientX - v.left, h.clientY - v.top];
  }, d = (h, v, P) => {
    let $ = Ot(h, v);
    $ && Se("point", $, (L) => {
      let A = L;
      A.hit && P?.(A);
    });
  }, m = (h) => {
    let v = ft();
    return v ? Math.max(0.2, q(N(h, v.eye), v.forward)) : r;
  };
  function f(h) {
    if (h.target.closest("[data-handle]")) return;
    e.focus({ preventScroll: !0 });
    let [v, P] = u(h), $ = h.pointerType === "touch", L = { alt: h.altKey, shift: h.shiftKey, ctrl: h.ctrlKey || h.metaKey, space: i }, A = $ ? "look" : Rl(Kn.peek(), h.button, L);
    A === "look" && ne()?.height && (A = "pan"), z.peek() === "marquee" && h.button === 0 && (A = "none"), n.set(h.pointerId, {
      id: h.pointerId,
      button: h.button,
      x: v,
      y: P,
      startX: v,
      startY: P,
      moved: !1,
      motion: A,
      touch: $,
      shift: h.shiftKey,
      ctrl: L.ctrl
    }), e.setPointerCapture(h.pointerId), clearTimeout(a), t.unhover(), (A === "orbit" || A === "pan" || A === "dolly") && (o = Dt(), r = m(o), d(v, P, (R) => {
      o = R.point, r = m(R.point);
    })), clearTimeout(s), $ && n.size === 1 && (s = window.setTimeout(() => {
      let R = n.get(h.pointerId);
      R && !R.moved && n.size === 1 && (R.moved = !0, R.motion = "none", t.menu(R.x, R.y));
    }, 550)), n.size === 2 && (c = y()), h.button === 1 && h.preventDefault();
  }
  function y() {
    let [h, v] = [...n.values()];
    return { gap: Math.hypot(h.x - v.x, h.y - v.y), x: (h.x + v.x) / 2, y: (h.y + v.y) / 2 };
  }
  function _(h) {
    let v = n.get(h.pointerId), [P, $] = u(h);
    if (!v) {
      if (h.pointerType === "touch" || h.buttons) return;
      t.unhover(), clearTimeout(a), a = window.setTimeout(() => t.hover(P, $), 150);
      return;
    }
    let [L, A] = [P - v.x, $ - v.y];
    if (!(!v.moved && Math.hypot(P - v.startX, $ - v.startY) < Il)) {
      if (v.moved = !0, v.x = P, v.y = $, n.size === 2 && c) {
        let R = y();
        Ft(R.x - c.x, R.y - c.y, r), R.gap > 8 && c.gap > 8 && b(R.x, R.y, c.gap / R.gap, !1), c = R;
        return;
      }
      if (z.peek() === "marquee" && v.button === 0) {
        t.marquee([v.startX, v.startY], [P, $], !1);
        return;
      }
      switch (v.motion) {
        case "look": {
          let R = v.touch ? 1 : -1;
          to(R * L * ja, R * A * ja);
          break;
        }
        case "orbit":
          no(o, -L * 6e-3, -A * 6e-3);
          break;
        case "pan":
          Ft(L, A, r);
          break;
        case "dolly":
          b(v.startX, v.startY, Math.exp(A * 6e-3), !1);
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
        z.peek() === "marquee" && t.marquee([v.startX, v.startY], [v.x, v.y], !0);
        return;
      }
      if (v.touch) {
        let P = performance.now(), $ = P - p < 320;
        if (p = P, $) return t.double();
        if (ve.peek()) return;
      }
      if (v.button === 2) t.menu(v.x, v.y);
      else if (v.button === 0) {
        let P = v.shift ? "add" : v.ctrl ? "toggle" : "only";
        t.click(v.x, v.y, P);
      }
    }
  }
  let M = null;
  function b(h, v, P, $) {
    let L = ne(), A = ft();
    if (!L || !A) return;
    if (L.height) return Q(Yn(L, A, h, v, P));
    let R = performance.now();
    if (!M || R - M.time > 500 || Math.hypot(h - M.x, v - M.y) > 6) {
      M = { x: h, y: v, time: R, point: null };
      let vt = M;
      d(h, v, (Ur) => {
        vt.point = Ur.point, r = m(Ur.point);
      });
    }
    M.time = R;
    let [es, ts] = [h - A.width / 2, A.height / 2 - v], ns = Math.min(r, De(L.eye, Dt()) + 1), wo = (vt) => L.eye[vt] + (A.forward[vt] + A.side[vt] * es * A.pixel + A.up[vt] * ts * A.pixel) * ns, jr = M.point ?? [wo(0), wo(1), wo(2)];
    Q(Xn(L, jr, P, Al, $)), $ && De(L.eye, jr) < 0.5 && (M = null);
  }
  function k(h) {
    if (h.target.closest("[data-scroll]")) return;
    h.preventDefault();
    let v = h.deltaMode === 1 ? 18 : h.deltaMode === 2 ? 400 : 1, [P, $] = [h.deltaX * v, h.deltaY * v], [L, A] = u(h);
    if (Kn.peek() === "trackpad" && !h.ctrlKey) return Ft(-P, -$, r);
    let R = (h.ctrlKey ? 6 : 1) * (Math.abs($) > Math.abs(P) ? $ : P);
    b(L, A, Math.exp(Math.max(-300, Math.min(300, R)) * 16e-4), h.shiftKey && !h.ctrlKey);
  }
  let V = (h) => h.preventDefault(), Me = () => {
    clearTimeout(a), t.unhover();
  }, Ze = (h) => {
    !h.target.closest("[data-handle]") && z.peek() === null && t.double();
  }, fe = (h) => {
    h.code === "Space" && (i = h.type === "keydown");
  }, he = new ResizeObserver(() => {
    let h = e.getBoundingClientRect();
    _e.value = [Math.max(16, Math.round(h.width)), Math.max(16, Math.round(h.height))];
  });
  return he.observe(e), e.addEventListener("pointerdown", f), e.addEventListener("pointermove", _), e.addEventListener("pointerup", w), e.addEventListener("pointercancel", w), e.addEventListener("pointerleave", Me), e.addEventListener("wheel", k, { passive: !1 }), e.addEventListener("contextmenu", V), e.addEventListener("dblclick", Ze), addEventListener("keydown", fe), addEventListener("keyup", fe), () => {
    he.disconnect(), removeEventListener("keydown", fe), removeEventListener("keyup", fe);
  };
}

// src/overlay.ts
var Hl = "http://www.w3.org/2000/svg";
function we(e, t = {}, n) {
  let o = document.createElementNS(Hl, e);
  for (let [r, i] of Object.entries(t)) o.setAttribute(r, String(i));
  return n?.append(o), o;
}
var Nr = class {
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
      let u = (i - o) / (r - o), d = I(S(t, 1 - u), S(n, u));
      o < i && (a = d), r < i && (s = d);
    }
    let [p, c] = [this.at(a), this.at(s)];
    return !p || !c ? "" : `M${p[0].toFixed(1)} ${p[1].toFixed(1)}L${c[0].toFixed(1)} ${c[1].toFixed(1)}`;
  }
};
function qr() {
  let e = W.value;
  return _e.value, e ? new Nr(Vt(e.camera, e.head.width, e.head.height)) : null;
}
function Wa() {
  let e = ie(qr);
  return e ? x.all().flatMap(([t, n]) => {
    let o = Ba(n), r = o && e.at(o);
    return r ? [{ id: t, at: r }] : [];
  }) : null;
}
var Ba = pr, Kl = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
function Fr(e, t) {
  let n = Lt(t);
  return Kl.map(([o, r]) => e.line(n[o], n[r])).join("");
}
var Ol = 150, xn = class {
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
        let p = we("g", { "data-kind": this.kind, "data-id": o }, this.parent);
        this.shape(p);
        let c = we("text", { x: 10, y: 4 }, p);
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
function za(e) {
  let t = we("path", { class: "aims" }, e), n = we("path", { class: "boxes" }, e), o = we("path", { class: "boxes hover" }, e), r = we("path", { class: "grid-lines" }, e), i = new xn(we("g", {}, e), "lamp", (u) => we("circle", { r: 4.5 }, u)), a = new xn(we("g", {}, e), "grid", () => {
  }), s = new xn(we("g", {}, e), "meter", (u) => {
    we("circle", { r: 5.5 }, u), we("path", { d: "M-9 0H9M0 -9V9" }, u);
  }), p = E(() => {
    let u = qr();
    if (!u) return;
    let d = T.value, m = de.value, f = "", y = "", _ = x.ids.value.length <= Ol, w = x.all().map(([b, k]) => {
      let V = d?.kind === "lamp" ? d.ids.includes(b) : d?.kind === "group" && d.ids.includes(k.group ?? -1), Me = m?.kind === "lamp" ? m.id === b : m?.kind === "group" && m.id === k.group, Ze = Ba(k), fe = k.place?.position;
      if (V && k.box && (y += Fr(u, k.box)), fe && k.place?.direction && (V || Me)) {
        let v = k.place.aim ?? I(fe, k.place.direction);
        f += u.line(fe, v);
      }
      let he = V || Me || _ && Wo.value && (k.own || k.place?.position), h = `${V ? "selected" : ""} ${Me ? "under" : ""} ${He(k) ? "" : "off"}`;
      return { id: b, at: Ze && he ? u.at(Ze) : null, label: V || Me ? k.name : "", state: h };
    });
    if (i.draw(w), t.setAttribute("d", f), d?.kind === "thing")
      for (let b of d.ids) {
        let k = ge.get(b)?.box;
        k && (y += Fr(u, k));
      }
    n.setAttribute("d", y);
    let M = m?.kind === "lamp" ? x.get(m.id)?.box : m?.kind === "thing" ? ge.get(m.id)?.box : null;
    o.setAttribute("d", M ? Fr(u, M) : "");
  }), c = E(() => {
    let u = qr();
    if (!u) return;
    let d = T.value, m = (y, _) => d?.kind === y && d.ids.includes(_) ? "selected" : "";
    s.draw(Ct.all().map(([y, _]) => ({
      id: y,
      at: u.at(_.point),
      label: _.lux ? dt(_.lux[0]) : "…",
      state: m("meter", y)
    })));
    let f = "";
    a.draw(Fn.all().map(([y, _]) => {
      f += Dl(u, _);
      let w = _.mean == null ? "…" : `${_.name} ${dt(_.mean)}`;
      return { id: y, at: u.at(_.corner), label: w, state: m("grid", y) };
    })), r.setAttribute("d", f);
  });
  return () => {
    p(), c(), e.replaceChildren();
  };
}
function Dl(e, t) {
  let n = (r, i) => I(t.corner, I(S(t.u, r), S(t.v, i))), o = e.line(n(0, 0), n(1, 0)) + e.line(n(1, 0), n(1, 1)) + e.line(n(1, 1), n(0, 1)) + e.line(n(0, 1), n(0, 0));
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
var Ga = () => `lampyris view ${J.peek()?.file ?? "SCENE"} --port ${location.port || 80}`;
function Fl() {
  let e = x.all().filter(([, n]) => !n.on || n.level === 0 || n.parked), t = D.all().filter(([, n]) => !n.on || n.level === 0);
  $e("All lamps on", {
    lamps: Object.fromEntries(e.map(([n, o]) => [n, { on: !0, parked: !1, ...o.level === 0 ? { level: 1 } : {} }])),
    groups: Object.fromEntries(t.map(([n, o]) => [n, { on: !0, ...o.level === 0 ? { level: 1 } : {} }]))
  });
}
function Nl() {
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
          l("code", { children: Ga() }),
          ": this page comes back by itself."
        ] }),
        l("button", { onClick: () => {
          vr(Ga());
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
              cr.value = "disc", fr("add");
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
        l("button", { onClick: Fl, children: "Turn on" })
      ] });
    case "slow":
      return l(ce, { tone: "calm", children: [
        "Slow connection.",
        l("button", { "aria-pressed": je.value, onClick: () => je.value = !0, children: "Sharper" }),
        l("button", { "aria-pressed": !je.value, onClick: () => je.value = !1, children: "Faster" })
      ] });
    default:
      return null;
  }
}
function Xa() {
  let e = ke.value;
  return l("div", { class: "banners", "data-scroll": !0, children: [
    Nl(),
    Je.value.length > 0 && l(ce, { tone: "calm", children: [
      l("details", { children: [
        l("summary", { children: [
          Je.value.length,
          " edits no longer find what they changed"
        ] }),
        l("ul", { children: Je.value.map((t) => l("li", { children: t }, t)) })
      ] }),
      l("button", { onClick: () => Je.value = [], children: "Good" })
    ] }),
    e.length > 0 && l("div", { class: "banner badge", role: "status", children: [
      "Solo: ",
      e.length === 1 ? x.get(e[0])?.name ?? "one lamp" : `${e.length} lamps`,
      l("button", { onClick: kr, children: "End solo" })
    ] }),
    l("div", { class: "notes", role: "status", "aria-live": "polite", children: st.value.map((t) => l("div", { class: `banner ${t.tone === "warn" ? "warn" : "calm"}`, children: [
      t.text,
      l("button", { class: "icon", "aria-label": "Close", onClick: () => Xo(t.id), children: l(G, { name: "close" }) })
    ] }, t.id)) })
  ] });
}

// src/view.tsx
var Qa = g(null);
function ql(e, t) {
  let n = Wa();
  if (!n) return [];
  let [o, r] = [Math.min(e[0], t[0]), Math.max(e[0], t[0])], [i, a] = [Math.min(e[1], t[1]), Math.max(e[1], t[1])];
  return n.filter(({ at: s }) => s[0] >= o && s[0] <= r && s[1] >= i && s[1] <= a).map(({ id: s }) => s);
}
var jl = {
  click(e, t, n) {
    let o = Ya(e, t);
    if (z.peek() === null && o) return Ge(o.kind, o.id, n);
    _o(e, t, (r) => {
      if (r && (eo.value = { point: r.point, normal: r.normal }), z.peek() !== null) return sa(r);
      ta(r, n), T.peek() && (Ie.value = "inspector");
    });
  },
  menu(e, t) {
    _o(e, t, (n) => {
      n && co(e, t, n);
    });
  },
  double() {
    lr();
  },
  hover(e, t) {
    let n = Ya(e, t);
    n?.kind === "lamp" && (de.value = { kind: "lamp", id: n.id }), _o(e, t, (o) => {
      yo.value = o, o && (eo.value = { point: o.point, normal: o.normal }), o?.lamp != null && (de.value = { kind: "lamp", id: o.lamp });
    });
  },
  unhover() {
    de.peek() && (de.value = null);
  },
  marquee(e, t, n) {
    if (Qa.value = n ? null : { from: e, to: t }, !n) return;
    let o = ql(e, t);
    T.value = o.length ? { kind: "lamp", ids: o } : null, z.value = null;
  }
};
function Ya(e, t) {
  let n = document.getElementById("overlay"), o = null, r = 11;
  for (let i of n?.querySelectorAll(".mark:not([display])") ?? []) {
    let a = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(i.getAttribute("transform") ?? "");
    if (!a) continue;
    let s = Math.hypot(Number(a[1]) - e, Number(a[2]) - t);
    s < r && (r = s, o = { kind: i.dataset.kind, id: Number(i.dataset.id) });
  }
  return o;
}
var Ul = {
  aim: "Click what shall be lit. Esc to leave.",
  meter: "Click where the meter shall lie. Esc to leave.",
  grid: "Click two opposite corners of the area. Esc to leave.",
  add: "Click where the lamp shall hang. Esc to leave.",
  marquee: "Drag around the lamps to select. Esc to leave."
};
function Ja() {
  let e = te(null), t = te(null), n = te(null);
  return Ce(() => {
    nr(t.current);
    let o = za(n.current), r = Ua(e.current, jl);
    return () => {
      nr(null), o(), r();
    };
  }, []), xi(() => {
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
          l(Wl, {})
        ]
      }
    ),
    l("p", { id: "view-keys", class: "spoken", children: "Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection, Escape leaves the view." }),
    z.value && l("p", { class: "hint", role: "status", children: Ul[z.value] }),
    l(Xa, {}),
    l(ee, { part: "Legend" }),
    l(ee, { part: "CutBar" }),
    l(ee, { part: "ViewStrip" }),
    l(ee, { part: "WalkPad" }),
    l(ee, { part: "What" })
  ] });
}
function Wl() {
  let e = Qa.value;
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
function Bl() {
  return l(X, { children: [
    l(ba, {}),
    l(Da, {}),
    l(Ja, {}),
    l("section", { class: "panel inspector", "aria-label": "Inspector", children: l(ee, { part: "Inspector" }) }),
    l("section", { class: "strip", "aria-label": "Looks and meters", children: l(ee, { part: "Strip" }) }),
    l(qa, {}),
    l(ee, { part: "Sheets" })
  ] });
}
var ht = document.getElementById("desk");
ht.replaceChildren();
oi(l(Bl, {}), ht);
E(() => {
  ht.dataset.state = Wt.value, ht.dataset.line = U.value, ht.dataset.pen = pe.value === "edit" && F.value.you && !ve.value ? "yes" : "no";
});
E(() => {
  ht.dataset.panels = jo.value ? "yes" : "no", ht.dataset.drawer = Ie.value ?? "none";
});
E(() => {
  document.documentElement.dataset.theme = Fo.value, document.documentElement.style.setProperty("--house", String(No.value));
});
E(() => {
  J.value && (document.title = `${J.value.name} – Lampyris`);
});
var Za = 0;
E(() => {
  let [e, t] = _e.value, n = je.value ? Math.min(devicePixelRatio, 2) : 1;
  U.value !== "open" || pe.value === "watch" || !F.value.you || (clearTimeout(Za), Za = window.setTimeout(() => K({ do: "size", width: Math.round(e * n), height: Math.round(t * n) }), 60));
});
da();
Pa();
Ki();
export {
  _n as Fade,
  gn as Field,
  X as Fragment,
  We as Gesture,
  G as Icon,
  _r as Item,
  Hs as PRESETS,
  Ar as Range,
  Kr as Virtual,
  ut as across,
  oe as act,
  I as add,
  cr as adding,
  al as allActions,
  Se as ask,
  la as asked,
  Ws as back,
  mn as before,
  wt as candles,
  le as chosenLamps,
  kr as clearSolo,
  fo as closeWhat,
  Ia as colorText,
  io as command,
  hn as compareHeld,
  me as comparing,
  Gi as compass,
  O as computed,
  vr as copyText,
  Rr as cost,
  be as cross,
  Ir as css,
  Qs as cut,
  Jn as deselect,
  B as digits,
  at as display,
  De as distance,
  q as dot,
  el as each,
  $e as edit,
  F as editor,
  E as effect,
  ao as exposeBy,
  Bo as fade,
  nl as falseColor,
  Es as filterOf,
  je as fine,
  dn as fitted,
  vn as format,
  Bs as forth,
  lr as frameSelection,
  oo as free,
  El as fromHex,
  Q as go,
  ur as goHome,
  Ys as goInside,
  Xs as goPreset,
  Fn as grids,
  D as groups,
  qs as handles,
  Kn as hands,
  xe as hear,
  ne as here,
  La as hex,
  uo as highlight,
  rt as history,
  No as houseLights,
  de as hovered,
  l as jsx,
  l as jsxs,
  Wo as lampMarks,
  x as lamps,
  on as layers,
  Oe as length,
  _t as listing,
  ve as lookOnly,
  Mt as looks,
  dt as luxText,
  Ms as maintenance,
  xt as materials,
  Ct as meters,
  Be as middle,
  Tl as mired,
  ea as nameOf,
  Z as normal,
  Zs as onTool,
  He as output,
  kl as padWalk,
  jo as panels,
  Bn as penless,
  Ae as percent,
  Hr as pickRow,
  Vt as pinhole,
  pr as positionOf,
  cn as project,
  Rs as ray,
  il as register,
  pe as role,
  ae as say,
  S as scale,
  J as scene,
  Ge as select,
  T as selection,
  K as send,
  Js as setCut,
  pt as sheet,
  $t as show,
  W as shown,
  g as signal,
  Uo as singleKeys,
  dl as soloSelection,
  eo as spot,
  fr as startTool,
  Te as status,
  Is as step,
  js as stepSelection,
  rl as storeLook,
  ol as storeView,
  Jo as stroke,
  vo as strokeLevel,
  N as sub,
  Vr as switchOn,
  Fo as theme,
  ge as things,
  Ye as three,
  Zn as titleOf,
  Tr as toLevel,
  Er as toTravel,
  hr as toggleFalse,
  ul as toggleWipe,
  z as tool,
  On as travel,
  un as turn,
  Lr as typeGroupLevel,
  $r as typeLevel,
  Ve as up,
  Ce as useEffect,
  ps as useLayoutEffect,
  te as useRef,
  Kt as viewName,
  _e as viewSize,
  St as views,
  Ea as walkNames,
  qo as walking,
  mr as wantLevel,
  Qe as what,
  zn as whyNot,
  gr as whyNotTo,
  sl as wipeAt
};
