// node_modules/preact/dist/preact.mjs
var M;
var Cr;
var wo;
var Fe;
var _o;
var In;
var Er;
var Ln;
var Pr;
var xo;
var ko;
var Ua;
var Ut = /* @__PURE__ */ Symbol.for("pv");
var Rn = {};
var Hn = [];
var Ba = /^m(i|n|o|s|text|space)$/;
var So = Array.isArray;
var Mo = Hn.slice;
var rt = Object.assign;
function ot(e) {
  e && e.parentNode && e.remove();
}
function Tr(e, t, n) {
  var o, r, i, a = {}, l = arguments.length;
  for (i in t) "key" == i ? o = t[i] : "ref" == i && "function" != typeof e ? r = t[i] : a[i] = t[i];
  return l > 2 && (a.children = l > 3 ? Mo.call(arguments, 2) : n), jt(e, a, o, r, null);
}
function jt(e, t, n, o, r) {
  var i = { type: e, props: t, key: n, ref: o, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: Ut, __v: r || ++Cr, __i: -1, __u: 0 };
  return !r && M.vnode && M.vnode(i), i;
}
function Q(e) {
  return e.children;
}
function xt(e, t) {
  this.props = e, this.context = t, this.__g = 0;
}
function qe(e, t) {
  if (null == t) return e.__ && qe(e.__, e.__i + 1);
  for (var n; t < e.__k.length; t++) if ((n = e.__k[t]) && n.__e) return n.__e;
  return "function" != typeof e.type || e.props.__P ? null : qe(e);
}
function za(e) {
  var t, n = e.__v, o = n.__e, r = [], i = [], a = e.__P;
  a && ((t = rt({ constructor: Ut }, n)).__v = n.__v + 1, M.vnode && M.vnode(t), Co(a, t, n, e.__n, a.namespaceURI, 32 & n.__u ? [o] : null, r, o || qe(n), 32 & n.__u, i), t.__v = n.__v, t.__.__k[t.__i] = t, Rr(r, t, i), n.__ = n.__e = null, t.__e != o && Vr(t));
}
function Vr(e) {
  if ((e = e.__) && e.__c && !e.props.__P) return e.__e = null, e.__k.some(function(t) {
    return t && (e.__e = t.__e);
  }), Vr(e);
}
function Sr(e) {
  (8 & e.__g || (e.__g |= 8, Fe.push(e), In++)) && _o == M.debounceRendering || ((_o = M.debounceRendering) || queueMicrotask)($r);
}
function $r() {
  try {
    for (var e, t = 1; Fe.length; ) Fe.length > t && Fe.sort(Er), e = Fe.shift(), t = Fe.length, 8 & e.__g && za(e);
  } finally {
    (In = Fe.length) && (_o || queueMicrotask)($r);
  }
}
function Lr(e, t, n, o, r, i, a, l, p, c, u) {
  var d, v, f, b, _, x, w = o.__k || Hn, y = t.length;
  for (p = Ga(n, t, w, p, y), d = 0; d < y; d++) null != (f = n.__k[d]) && (v = ~f.__i && w[f.__i] || Rn, f.__i = d, x = Co(e, f, v, r, i, a, l, p, c, u), b = f.__e, (v.ref != f.ref || 8 & v.__u) && (v.ref && Eo(v.ref, null, f, v), f.ref && u.push(f.ref, f.__c || b, f)), _ = _ || b, 4 & f.__u ? (p = Ar(f, p, e, !v.__v), v.__e && (v.__e = null)) : "function" == typeof f.type && void 0 !== x ? p = x : b && (p = b.nextSibling), f.__u &= -21);
  return n.__e = _, p;
}
function Ga(e, t, n, o, r) {
  var i, a, l, p, c, u, d, v, f, b = n.length, _ = b, x = 0, w = 0, y = e.__k = Array(r);
  for (i = 0; i < r; i++) null != (a = t[i]) && "boolean" != typeof a && "function" != typeof a ? ("object" != typeof a || a.constructor === String ? a = y[i] = jt(null, a) : So(a) ? a = y[i] = jt(Q, { children: a }) : a.constructor === Ut && a.__b ? a = y[i] = jt(a.type, a.props, a.key, a.ref, a.__v) : y[i] = a, p = i + x, a.__ = e, a.__b = e.__b + 1, l = null, ~(c = a.__i = Xa(a, n, p, _)) && (_--, (l = n[c]) && (l.__u |= 2)), l && l.__v ? (a.__u |= 16, c == p - 1 ? x-- : c == p + 1 ? x++ : c != p && (c > p ? x-- : x++, w = 1)) : (~c || (r > b ? x-- : r < b && x++), "function" != typeof a.type && (a.__u |= 4))) : y[i] = null;
  if (w) {
    for (u = [], d = [], i = 0; i < r; i++) if ((a = y[i]) && 16 & a.__u) {
      for (x = 0, v = u.length; x < v; ) u[f = x + v >> 1] < a.__i ? x = f + 1 : v = f;
      u[x] = a.__i, d[i] = x + 1;
    }
    for (x = u.length; i--; ) d[i] && (d[i] == x ? x-- : y[i].__u |= 4);
  }
  if (_) for (i = 0; i < b; i++) !(l = n[i]) || 2 & l.__u || (l.__e == o && (o = qe(l)), Po(l, l));
  return o;
}
function Ar(e, t, n, o) {
  var r, i, a, l;
  if ("function" == typeof e.type) {
    if (e.props.__P) return t;
    if (r = e.__k) for (i = 0; i < r.length; i++) r[i] && (r[i].__ = e, t = Ar(r[i], t, n, false));
    return t;
  }
  for (t && !t.parentNode && (t = qe(e)) && !t.parentNode && (t = null), a = e.__e, l = t; l && 8 == l.nodeType; ) l = l.nextSibling;
  for (a != l && (!o && n.moveBefore && a.parentNode ? n.moveBefore(a, t) : n.insertBefore(a, t || null)), t = a; (t = t && t.nextSibling) && 8 == t.nodeType && !t.data.startsWith("$s"); ) ;
  return t;
}
function Xa(e, t, n, o) {
  var r, i = e.key, a = e.type, l = t[n], p = l && !(2 & l.__u);
  if (null === l && null == i || p && i == l.key && a == l.type) return n;
  if (o > (p ? 1 : 0)) {
    for (r = n - 1; r >= 0; r--) if ((l = t[r]) && !(2 & l.__u) && i == l.key && a == l.type) return r;
    for (r = n + 1; r < t.length; r++) if ((l = t[r]) && !(2 & l.__u) && i == l.key && a == l.type) return r;
  }
  return -1;
}
function Mr(e, t, n) {
  null == n && (n = ""), "-" == t[0] ? e.setProperty(t, n) : e[t] = n;
}
function $n(e, t, n, o, r) {
  var i, a;
  if ("style" == t) if ("string" == typeof n) e.style.cssText = n;
  else {
    if ("string" == typeof o && (e.style.cssText = o = ""), o) for (t in o) n && t in n || Mr(e.style, t);
    if (n) for (t in n) o && n[t] == o[t] || Mr(e.style, t, n[t]);
  }
  else if ("o" == t[0] && "n" == t[1]) "function" != typeof n && (n = null), "function" != typeof o && (o = null), (e.__e || (e.__e = {}))[t] = n, n && o || (a = ko[t] || (ko[t] = Ya(t)), (e.__a || (e.__a = {}))[t] = xo, i = t != (t = t.replace(Pr, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), n ? e.addEventListener(t, a, i) : e.removeEventListener(t, a, i));
  else {
    if ("http://www.w3.org/2000/svg" == r) t = t.replace(/xlink(H|:h)/, "h").replace(/sName$/, "s");
    else if ("width" != t && "height" != t && "href" != t && "list" != t && "form" != t && "tabIndex" != t && "download" != t && "rowSpan" != t && "colSpan" != t && "role" != t && "popover" != t && t in e) try {
      return void (e[t] = null == n ? "" : n);
    } catch (l) {
    }
    if ("function" == typeof n) return;
    null == n || false === n && "-" != t[4] ? e.removeAttribute(t) : e.setAttribute(t, "popover" == t && 1 == n ? "" : n);
  }
}
function Ya(e) {
  return function(t) {
    var n = this.__e;
    if (n) {
      if (n = n[e], null == t[Ln]) t[Ln] = xo++;
      else if (t[Ln] < this.__a[e]) return;
      return n(M.event ? M.event(t) : t);
    }
  };
}
function Co(e, t, n, o, r, i, a, l, p, c) {
  var u, d, v, f, b, _, x, w, y, I, $, Ne, Oe, _e, de, m, h, P, T = t.type;
  if (t.constructor !== Ut) return null;
  128 & n.__u && (p = 32 & n.__u, u = n.__c.__z) && (t.__u |= p, d = i = [], 8 == u.nodeType ? l = An(u, i) : i.push(u), l = i[0] || l), (u = M.__b) && u(t);
  e: if ("function" == typeof T) {
    v = a.length;
    try {
      if (w = t.props, y = (u = T.prototype) && u.render, I = (u = T.contextType) && o[u.__c], $ = u ? I ? I.props.value : u.__ : o, (f = n.__c) ? (t.__c = f, 2 & f.__g && (f.__g |= 1)) : (y ? t.__c = f = new T(w, $) : (t.__c = f = new xt(w, $), f.constructor = T, f.render = Qa), I && I.sub(f), f.state || (f.state = {}), f.__n = o, f.__g |= 8, f.__h = [], f.__k = []), y && (f.__s || (f.__s = f.state), T.getDerivedStateFromProps && (f.__s == f.state && (f.__s = rt({}, f.__s)), rt(f.__s, T.getDerivedStateFromProps(w, f.__s)))), b = f.props, _ = f.state, f.__v = t, n.__c) {
        if (w !== b && y && !T.getDerivedStateFromProps && f.componentWillReceiveProps && f.componentWillReceiveProps(w, $), t.__v == n.__v && !(8 & f.__g) || !(4 & f.__g) && f.shouldComponentUpdate && false === f.shouldComponentUpdate(w, f.__s, $)) {
          t.__v != n.__v && (f.props = w, f.state = f.__s, f.__g &= -9), t.__e = n.__e, t.__k = n.__k, t.__k.some(function(V) {
            V && (V.__ = t);
          }), Hn.push.apply(f.__h, f.__k), f.__k = [], f.__h.length && a.push(f), l = qe(n);
          break e;
        }
        f.componentWillUpdate && f.componentWillUpdate(w, f.__s, $), y && f.componentDidUpdate && f.__h.push(function() {
          f.componentDidUpdate(b, _, x);
        });
      } else y && !T.getDerivedStateFromProps && f.componentWillMount && f.componentWillMount(), y && f.componentDidMount && f.__h.push(f.componentDidMount);
      f.context = $, f.props = w, f.__P = e, f.__g &= -5, Ne = M.__r, Oe = y ? 25 : 0;
      do {
        f.__g &= -9, Ne && Ne(t), u = f.render(f.props, f.state = f.__s, f.context);
      } while (8 & f.__g && ++Oe < 25);
      y && (Hn.push.apply(f.__h, f.__k), f.__k = []), f.state = f.__s, f.getChildContext && (o = rt({}, o, f.getChildContext())), y && n.__c && f.getSnapshotBeforeUpdate && (x = f.getSnapshotBeforeUpdate(b, _)), _e = u && u.type === Q && null == u.key ? u.props.children : u, w.__P && (u = l, r = (e = w.__P).namespaceURI, p = i = null, n.props && n.props.__P != e && (n.__k.some(function(V) {
        V && Po(V, V);
      }), n.__k = null), l = n.__k ? qe(n, 0) : null), l = Lr(e, So(_e) ? _e : [_e], t, n, o, r, i, a, l, p, c), w.__P && (t.__e = null, l = u), t.__u &= -161, d && d.some(ot), f.__h.length && a.push(f), 1 & f.__g && (f.__g &= -4);
    } catch (V) {
      if (a.length = v, t.__v = null, p || i) if (V && V.then) {
        if (t.__u |= 128 | p, i) {
          for (~(h = i.indexOf(l || void 0)) || (h = i.length); (P = i[h - 1]) && 8 == P.nodeType; ) h--;
          for (; h < i.length; h++) if (P = i[h]) if (i[h] = null, de) {
            if (P == m) break;
          } else {
            if (8 != P.nodeType) break;
            P.data.startsWith("$s") && (m = An(de = P));
          }
        }
        if (!de) {
          for (; l && 8 == l.nodeType && l.nextSibling; ) l = l.nextSibling;
          de = l;
        }
        (u = An(de = t.__c.__z || (t.__c.__z = de))) ? (t.__e = de, l = u) : t.__e = l, l = l && l.nextSibling;
      } else i && i.some(ot);
      else t.__e = n.__e;
      t.__k || (t.__k = n.__k || []), V && V.then || Ir(t), M.__e(V, t, n);
    }
  } else l = t.__e = Ja(n.__e, t, n, o, r, i, a, p, c, e);
  return (u = M.diffed) && u(t), l;
}
function An(e, t) {
  if (e && 8 == e.nodeType && e.data.startsWith("$s")) for (var n = 1; e = e.nextSibling; ) {
    if (8 == e.nodeType) {
      if (e.data.startsWith("$s")) n++;
      else if (e.data.startsWith("/$s") && !--n) return e;
    }
    t && t.push(e);
  }
}
function Ir(e) {
  e && (e.__c && (e.__c.__g |= 4), e.__k && e.__k.some(Ir));
}
function Rr(e, t, n) {
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
function Ja(e, t, n, o, r, i, a, l, p, c) {
  var u, d, v, f, b, _, x, w, y = n.props || Rn, I = t.props, $ = t.type;
  if ("svg" == $ ? r = "http://www.w3.org/2000/svg" : "math" == $ ? r = "http://www.w3.org/1998/Math/MathML" : r || (r = "http://www.w3.org/1999/xhtml"), i) {
    for (u = 0; u < i.length; u++) if ((b = i[u]) && ($ ? b.localName == $ : 3 == b.nodeType)) {
      e = b, i[u] = null;
      break;
    }
  }
  if (!e) {
    if (w = c.ownerDocument || document, !$) return w.createTextNode(I);
    e = w.createElementNS(r, $, I.is ? I : c), l && (M.__m && M.__m(t, i), l = false), i = null;
  }
  if ($) {
    if (c = "template" == $ && e.content || e, i = "textarea" == $ && null != I.defaultValue ? null : i && Mo.call(c.childNodes), !l && i) for (y = {}, u = 0; u < e.attributes.length; u++) y[(b = e.attributes[u]).name] = b.value;
    for (u in y) b = y[u], "dangerouslySetInnerHTML" == u ? v = b : "children" == u || u in I || "value" == u && "defaultValue" in I || "checked" == u && "defaultChecked" in I || $n(e, u, null, b, r);
    for (u in I) b = I[u], "children" == u ? f = b : "dangerouslySetInnerHTML" == u ? d = b : "value" == u ? _ = b : "checked" == u ? x = b : l && "function" != typeof b || y[u] === b || $n(e, u, b, y[u], r);
    d ? (l || v && (d.__html == v.__html || d.__html == e.innerHTML) || (e.innerHTML = d.__html), t.__k = []) : (v && (e.textContent = ""), ("foreignObject" == $ || "http://www.w3.org/1998/Math/MathML" == r && Ba.test($)) && (r = "http://www.w3.org/1999/xhtml"), Lr(c, So(f) ? f : [f], t, n, o, r, i, a, i ? i[0] : n.__k && qe(n, 0), l, p), i && i.some(ot)), l && "textarea" != $ || (u = "value", "progress" == $ && null == _ ? e.removeAttribute(u) : null == _ || _ === e[u] && ("progress" != $ || _) || $n(e, u, _, y[u], r), u = "checked", null != x && x != e[u] && $n(e, u, x, y[u], r));
  } else y === I || l && e.data == I || (e.data = I);
  return e;
}
function Eo(e, t, n, o) {
  try {
    "function" == typeof e ? t ? t.__x = e(t) || 1 : o && (o = o.__c || o.__e) && (t = o.__x) && (o.__x = null, "function" == typeof t ? t() : e(null)) : e.current = t;
  } catch (r) {
    M.__e(r, n);
  }
}
function Po(e, t, n) {
  var o, r, i, a;
  if (M.unmount && M.unmount(e), !(o = e.ref) || o.current && o.current != e.__e || Eo(o, null, t, e), o = e.__c) {
    if (o.componentWillUnmount) try {
      o.componentWillUnmount();
    } catch (l) {
      M.__e(l, t);
    }
    o.__P = o.__n = null;
  }
  if (o = e.__k) for (a = 0; a < o.length; a++) o[a] && Po(o[a], t, "function" != typeof e.type || n && !e.props.__P);
  !n && (o = e.__c) && (o = o.__z) && (r = An(o, i = [])) && (o == e.__e && i.some(ot), ot(r), ot(o)), n || ot(e.__e), e.__e = e.__c = e.__ = null;
}
function Qa(e, t, n) {
  return this.constructor(e, n);
}
function Hr(e, t) {
  var n, o, r, i;
  M.__ && M.__(e, t), 9 == t.nodeType && (t = t.documentElement), o = (n = e && 32 & e.__u) ? null : t.__k, t.__k = jt(Q, { children: [e] }), r = [], i = [], Co(t, t.__k, o || Rn, Rn, t.namespaceURI, o ? null : t.firstChild ? Mo.call(t.childNodes) : null, r, o ? o.__e : t.firstChild, n, i), Rr(r, t.__k, i), t.__k.props.children = null;
}
M = { __e: function(e, t, n, o) {
  for (var r, i, a; t = t.__; ) if ((r = t.__c) && !(1 & r.__g)) {
    r.__g |= 4;
    try {
      if ((a = (i = r.constructor) && i.getDerivedStateFromError) && r.setState(i.getDerivedStateFromError(e)), r.componentDidCatch && (r.componentDidCatch(e, o || {}), a = 1), a && 8 & r.__g) return void (r.__g |= 2);
    } catch (l) {
      e = l;
    }
  }
  throw In = 0, e;
} }, Cr = 0, wo = function(e) {
  return null != e && e.constructor === Ut;
}, xt.prototype.setState = function(e, t) {
  var n = this.__s;
  n && n != this.state || (n = this.__s = rt({}, this.state)), "function" == typeof e && (e = e(rt({}, n), this.props)), e && (rt(n, e), this.__v && (t && this.__k.push(t), Sr(this)));
}, xt.prototype.forceUpdate = function(e) {
  this.__v && (this.__g |= 4, e && this.__h.push(e), Sr(this));
}, xt.prototype.render = Q, Fe = [], In = 0, Er = function(e, t) {
  return e.__v.__b - t.__v.__b;
}, Ln = /* @__PURE__ */ Symbol(), Pr = /(PointerCapture)$|Capture$/i, xo = 0, ko = {}, Ua = 0;

// node_modules/preact/hooks/dist/hooks.mjs
var Dn;
var se;
var To;
var Dr;
var Za = Object.is;
var Vo = 0;
var Br = [];
var $o = [];
var z = M;
var Kr = z.__b;
var Nr = z.__r;
var Or = z.diffed;
var Fr = z.__c;
var qr = z.unmount;
var Wr = z.__;
function zr(e, t) {
  z.__h && z.__h(se, e, Vo || t), Vo = 0;
  var n = se.__H || (se.__H = { __: [], __h: [] });
  return e >= n.__.length && n.__.push({}), n.__[e];
}
function it(e, t) {
  var n = zr(Dn++, 3);
  !z.__s && Gr(n.__H, t) && (n.__P = true, n.__ = e, n.u = t, se.__H.__h.push(n));
}
function ne(e) {
  return Vo = 5, zt(function() {
    return { current: e };
  }, []);
}
function zt(e, t) {
  var n = zr(Dn++, 7);
  return Gr(n.__H, t) && (n.__ = e(), n.__H = t), n.__;
}
function es() {
  var e;
  do {
    for (; e = $o.shift(); ) try {
      Bt(e);
    } catch (n) {
      z.__e(n, { __: (e = e.__P) && e.__v });
    }
    for (; e = Br.shift(); ) {
      var t = e.__H;
      if (e.__P && t) try {
        t.__h.some(Bt), t.__h.some(Lo), t.__h = [];
      } catch (n) {
        t.__h = [], z.__e(n, e.__v);
      }
    }
  } while ($o.length);
}
z.__b = function(e) {
  se = null, Kr && Kr(e);
}, z.__ = function(e, t) {
  e && t.__k && t.__k.__m && (e.__m = t.__k.__m), Wr && Wr(e, t);
}, z.__r = function(e) {
  Nr && Nr(e), Dn = 0;
  var t = (se = e.__c).__H;
  t && (To == se ? se.__h = [] : (t.__h.some(Bt), t.__h.some(Lo), Dn = 0), t.__h = [], t.__.some(function(n) {
    n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
  })), To = se;
}, z.diffed = function(e) {
  Or && Or(e);
  var t = e.__c;
  t && t.__H && (t.__H.__h.length && Ur(Br.push(t)), t.__H.__.some(function(n) {
    n.u && (n.__H = n.u);
  })), To = se = null;
}, z.__c = function(e, t) {
  t.some(function(n) {
    try {
      n.__h.some(Bt), n.__h = n.__h.filter(function(o) {
        return !o.__ || Lo(o);
      });
    } catch (o) {
      n.__h = [function() {
        throw o;
      }];
    }
  }), Fr && Fr(e, t);
}, z.unmount = function(e) {
  qr && qr(e);
  var t, n, o = e.__c;
  o && o.__H && (o.__H.__.some(function(r) {
    try {
      if (r.__P && r.__c) {
        if (void 0 === n) {
          for (n = e.__; n && (!n.__c || !n.__c.__P); ) n = n.__;
          n = n && n.__c;
        }
        r.__P = n, Ur($o.push(r));
      } else Bt(r);
    } catch (i) {
      t = i;
    }
  }), o.__H = void 0, t && z.__e(t, o.__v));
};
var jr = "function" == typeof requestAnimationFrame;
function ts(e) {
  var t, n = function() {
    clearTimeout(o), jr && cancelAnimationFrame(t), setTimeout(e);
  }, o = setTimeout(n, 35);
  jr && (t = requestAnimationFrame(n));
}
function Ur(e) {
  1 != e && Dr == z.requestAnimationFrame || ((Dr = z.requestAnimationFrame) || ts)(es);
}
function Bt(e) {
  var t = se, n = e.__c;
  "function" == typeof n && (e.__c = void 0, n()), se = t;
}
function Lo(e) {
  var t = se;
  e.__c = e.__(), se = t;
}
function Gr(e, t) {
  return !e || e.length != t.length || t.some(function(n, o) {
    return !Za(n, e[o]);
  });
}

// node_modules/@preact/signals-core/dist/signals-core.module.js
var ns = /* @__PURE__ */ Symbol.for("preact-signals");
function Fn() {
  if (!(Te > 1)) {
    var e, t = false;
    !(function() {
      var r = Nn;
      Nn = void 0;
      while (void 0 !== r) {
        var i = r.S;
        if (i.v === r.v) {
          for (var a = i.t; void 0 !== a; a = a.x) if (a.i === r.i) a.i = i.i;
        }
        r = r.o;
      }
    })();
    while (void 0 !== Xt) {
      var n = Xt;
      Xt = void 0;
      Kn++;
      while (void 0 !== n) {
        var o = n.u;
        n.u = void 0;
        n.f &= -3;
        if (!(8 & n.f) && Yr(n)) try {
          n.c();
        } catch (r) {
          if (!t) {
            e = r;
            t = true;
          }
        }
        n = o;
      }
    }
    Kn = 0;
    Te--;
    if (t) throw e;
  } else Te--;
}
function qn(e) {
  if (Te > 0) return e();
  Ao = ++os;
  Te++;
  try {
    return e();
  } finally {
    Fn();
  }
}
var Gt;
var H = void 0;
function oe(e) {
  var t = H, n = Gt;
  H = void 0;
  Gt = void 0;
  try {
    return e();
  } finally {
    H = t;
    Gt = n;
  }
}
var Xt = void 0;
var Te = 0;
var Kn = 0;
var os = 0;
var Ao = 0;
var Nn = void 0;
var On = 0;
function Xr(e) {
  if (void 0 !== H) {
    var t = e.n;
    if (void 0 === t || t.t !== H) {
      t = { i: 0, S: e, p: H.s, n: void 0, t: H, e: void 0, x: void 0, r: t };
      if (void 0 !== H.s) H.s.n = t;
      H.s = t;
      e.n = t;
      if (32 & H.f) e.S(t);
      return t;
    } else if (-1 === t.i) {
      t.i = 0;
      if (void 0 !== t.n) {
        t.n.p = t.p;
        if (void 0 !== t.p) t.p.n = t.n;
        t.p = H.s;
        t.n = void 0;
        H.s.n = t;
        H.s = t;
      }
      return t;
    }
  }
}
function X(e, t) {
  this.v = e;
  this.i = 0;
  this.n = void 0;
  this.t = void 0;
  this.l = 0;
  this.W = null == t ? void 0 : t.watched;
  this.Z = null == t ? void 0 : t.unwatched;
  this.name = null == t ? void 0 : t.name;
}
X.prototype.brand = ns;
X.prototype.h = function() {
  return true;
};
X.prototype.S = function(e) {
  var t = this, n = this.t;
  if (n !== e && void 0 === e.e) {
    e.x = n;
    this.t = e;
    if (void 0 !== n) n.e = e;
    else oe(function() {
      var o;
      null == (o = t.W) || o.call(t);
    });
  }
};
X.prototype.U = function(e) {
  var t = this;
  if (void 0 !== this.t) {
    var n = e.e, o = e.x;
    if (void 0 !== n) {
      n.x = o;
      e.e = void 0;
    }
    if (void 0 !== o) {
      o.e = n;
      e.x = void 0;
    }
    if (e === this.t) {
      this.t = o;
      if (void 0 === o) oe(function() {
        var r;
        null == (r = t.Z) || r.call(t);
      });
    }
  }
};
X.prototype.subscribe = function(e) {
  var t = this;
  return E(function() {
    var n = t.value;
    oe(function() {
      return e(n);
    });
  }, { name: "sub" });
};
X.prototype.valueOf = function() {
  return this.value;
};
X.prototype.toString = function() {
  return this.value + "";
};
X.prototype.toJSON = function() {
  return this.value;
};
X.prototype.peek = function() {
  var e = this;
  return oe(function() {
    return e.value;
  });
};
Object.defineProperty(X.prototype, "value", { get: function() {
  var e = Xr(this);
  if (void 0 !== e) e.i = this.i;
  return this.v;
}, set: function(e) {
  if (e !== this.v) {
    if (Kn > 100) throw new Error("Cycle detected");
    !(function(n) {
      if (0 !== Te && 0 === Kn) {
        if (n.l !== Ao) {
          n.l = Ao;
          Nn = { S: n, v: n.v, i: n.i, o: Nn };
        }
      }
    })(this);
    this.v = e;
    this.i++;
    On++;
    Te++;
    try {
      for (var t = this.t; void 0 !== t; t = t.x) t.t.N();
    } finally {
      Fn();
    }
  }
} });
function g(e, t) {
  return new X(e, t);
}
function Yr(e) {
  for (var t = e.s; void 0 !== t; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return true;
  return false;
}
function Jr(e) {
  for (var t = e.s; void 0 !== t; t = t.n) {
    var n = t.S.n;
    if (void 0 !== n) t.r = n;
    t.S.n = t;
    t.i = -1;
    if (void 0 === t.n) {
      e.s = t;
      break;
    }
  }
}
function Qr(e) {
  var t = e.s, n = void 0;
  while (void 0 !== t) {
    var o = t.p;
    if (-1 === t.i) {
      t.S.U(t);
      if (void 0 !== o) o.n = t.n;
      if (void 0 !== t.n) t.n.p = o;
    } else n = t;
    t.S.n = t.r;
    if (void 0 !== t.r) t.r = void 0;
    t = o;
  }
  e.s = n;
}
function at(e, t) {
  X.call(this, void 0, t);
  this.x = e;
  this.s = void 0;
  this.g = On - 1;
  this.f = 4;
}
at.prototype = new X();
at.prototype.h = function() {
  this.f &= -3;
  if (1 & this.f) return false;
  if (32 == (36 & this.f)) return true;
  this.f &= -5;
  if (this.g === On) return true;
  this.g = On;
  this.f |= 1;
  if (this.i > 0 && !Yr(this)) {
    this.f &= -2;
    return true;
  }
  var e = H;
  try {
    Jr(this);
    H = this;
    var t = this.x();
    if (16 & this.f || this.v !== t || 0 === this.i) {
      this.v = t;
      this.f &= -17;
      this.i++;
    }
  } catch (n) {
    this.v = n;
    this.f |= 16;
    this.i++;
  }
  H = e;
  Qr(this);
  this.f &= -2;
  return true;
};
at.prototype.S = function(e) {
  if (void 0 === this.t) {
    this.f |= 36;
    for (var t = this.s; void 0 !== t; t = t.n) t.S.S(t);
  }
  X.prototype.S.call(this, e);
};
at.prototype.U = function(e) {
  if (void 0 !== this.t) {
    X.prototype.U.call(this, e);
    if (void 0 === this.t) {
      this.f &= -33;
      for (var t = this.s; void 0 !== t; t = t.n) t.S.U(t);
    }
  }
};
at.prototype.N = function() {
  if (!(2 & this.f)) {
    this.f |= 6;
    for (var e = this.t; void 0 !== e; e = e.x) e.t.N();
  }
};
Object.defineProperty(at.prototype, "value", { get: function() {
  if (1 & this.f) throw new Error("Cycle detected");
  var e = Xr(this);
  this.h();
  if (void 0 !== e) e.i = this.i;
  if (16 & this.f) throw this.v;
  return this.v;
} });
function Y(e, t) {
  return new at(e, t);
}
function Zr(e) {
  var t = e.j;
  e.j = void 0;
  if ("function" == typeof t) {
    Te++;
    var n = H;
    H = void 0;
    try {
      t();
    } catch (o) {
      e.f &= -2;
      e.f |= 8;
      Io(e);
      throw o;
    } finally {
      H = n;
      Fn();
    }
  }
}
function Io(e) {
  for (var t = e.s; void 0 !== t; t = t.n) t.S.U(t);
  e.x = void 0;
  e.s = void 0;
  Zr(e);
}
function rs(e) {
  if (H !== this) throw new Error("Out-of-order effect");
  Qr(this);
  H = e;
  this.f &= -2;
  try {
    if (8 & this.f) Io(this);
  } finally {
    Fn();
  }
}
function St(e, t) {
  this.x = e;
  this.j = void 0;
  this.s = void 0;
  this.u = void 0;
  this.f = 32;
  this.name = null == t ? void 0 : t.name;
  if (Gt) Gt.push(this);
}
St.prototype.c = function() {
  var e = this.S();
  try {
    if (8 & this.f) return;
    if (void 0 === this.x) return;
    var t = this.x();
    if ("function" == typeof t) this.j = t;
  } finally {
    e();
  }
};
St.prototype.S = function() {
  if (1 & this.f) throw new Error("Cycle detected");
  this.f |= 1;
  this.f &= -9;
  Zr(this);
  Jr(this);
  Te++;
  var e = H;
  H = this;
  return rs.bind(this, e);
};
St.prototype.N = function() {
  if (!(2 & this.f)) {
    this.f |= 2;
    this.u = Xt;
    Xt = this;
  }
};
St.prototype.d = function() {
  this.f |= 8;
  if (!(1 & this.f)) Io(this);
};
St.prototype.dispose = function() {
  this.d();
};
function E(e, t) {
  var n = new St(e, t);
  try {
    n.c();
  } catch (r) {
    n.d();
    throw r;
  }
  var o = n.d.bind(n);
  o[Symbol.dispose] = o;
  return o;
}

// node_modules/@preact/signals/dist/signals.module.js
var Ro;
var Mt;
var Wn;
var is = "undefined" != typeof window && !!window.__PREACT_SIGNALS_DEVTOOLS__;
var ei = [];
var ti = [];
E(function() {
  Ro = this.N;
})();
function Ct(e, t) {
  M[e] = t.bind(null, M[e] || function() {
  });
}
function Yt(e) {
  if (Wn) {
    var t = Wn;
    Wn = void 0;
    t();
  }
  Wn = e && e.S();
}
function ni(e) {
  var t = this, n = e.data, o = Jt(n);
  o.name = "ReactiveDom";
  o.value = n;
  var r = zt(function() {
    var l = t, p = t.__v;
    while (p = p.__) if (p.__c) {
      p.__c.__$f |= 4;
      break;
    }
    var c = Y(function() {
      var f = o.value.value;
      return 0 === f ? 0 : true === f ? "" : f || "";
    }), u = Y(function() {
      return !Array.isArray(c.value) && !wo(c.value);
    }), d = E(function() {
      this.N = oi;
      if (u.value) {
        var f = c.value;
        if (l.__v && l.__v.__e && 3 === l.__v.__e.nodeType) l.__v.__e.data = f;
      }
    }), v = t.__$u.d;
    t.__$u.d = function() {
      d();
      v.call(this);
    };
    return [u, c];
  }, []), i = r[0], a = r[1];
  return i.value ? a.peek() : a.value;
}
ni.displayName = "ReactiveTextNode";
Object.defineProperties(X.prototype, { constructor: { configurable: true, value: Tr(Q, null).constructor }, type: { configurable: true, value: ni }, props: { configurable: true, get: function() {
  var e = this;
  return { data: { get value() {
    return e.value;
  } } };
} }, __b: { configurable: true, value: 1 } });
Ct("__b", function(e, t) {
  Yt();
  Mt = void 0;
  if ("string" == typeof t.type) {
    var n, o = t.props;
    for (var r in o) if ("children" !== r) {
      var i = o[r];
      if (i instanceof X) {
        if (!n) t.__np = n = {};
        n[r] = i;
        o[r] = i.peek();
      }
    }
  }
  e(t);
});
Ct("__r", function(e, t) {
  e(t);
  if (t.type !== Q) {
    Yt();
    var n, o = t.__c;
    if (o) {
      o.__$f &= -2;
      if (void 0 === (n = o.__$u)) o.__$u = n = (function(r, i) {
        var a;
        E(function() {
          a = this;
        }, { name: i });
        a.c = r;
        return a;
      })(/* @__PURE__ */ (function(r) {
        return function() {
          var i;
          if (is) null == (i = this.y) || i.call(this);
          r.__$f |= 1;
          r.setState({});
        };
      })(o), "function" == typeof t.type ? t.type.displayName || t.type.name : "");
    }
    Mt = o;
    Yt(n);
  }
});
Ct("__e", function(e, t, n, o) {
  Yt();
  Mt = void 0;
  e(t, n, o);
});
Ct("diffed", function(e, t) {
  Yt();
  Mt = void 0;
  var n;
  if ("string" == typeof t.type && (n = t.__e)) {
    var o = t.__np, r = t.props, i = n.U;
    if (i) for (var a in i) {
      var l = i[a];
      if (!(void 0 === l || o && a in o)) {
        l.d();
        i[a] = void 0;
      }
    }
    if (o) {
      if (!i) {
        i = {};
        n.U = i;
      }
      for (var p in o) {
        var c = i[p], u = o[p];
        if (void 0 === c) {
          c = as(n, p, u, r);
          i[p] = c;
        } else c.o(u, r);
      }
    }
  }
  e(t);
});
function as(e, t, n, o) {
  var r = t in e && void 0 === e.ownerSVGElement, i = g(n);
  return { o: function(a, l) {
    i.value = a;
    o = l;
  }, d: E(function() {
    this.N = oi;
    var a = i.value.value;
    if (o[t] !== a) {
      o[t] = a;
      if (r) e[t] = a;
      else if (null != a && (false !== a || "-" === t[4])) e.setAttribute(t, a);
      else e.removeAttribute(t);
    }
  }) };
}
Ct("unmount", function(e, t) {
  if ("string" == typeof t.type) {
    var n = t.__e;
    if (n) {
      var o = n.U;
      if (o) {
        n.U = void 0;
        for (var r in o) {
          var i = o[r];
          if (i) i.d();
        }
      }
    }
    var a = t.__np;
    if (a) {
      var l = t.props;
      for (var p in a) l[p] = a[p];
    }
    t.__np = void 0;
  } else {
    var c = t.__c;
    if (c) {
      c.__$f |= 8;
      var u = c.__$u;
      if (u) {
        c.__$u = void 0;
        u.d();
      }
    }
  }
  e(t);
});
Ct("__h", function(e, t, n, o) {
  if (o < 3) t.__$f |= 2;
  e(t, n, o);
});
xt.prototype.shouldComponentUpdate = function(e, t) {
  if (this.__R) return true;
  var n = this.__$u, o = n && void 0 !== n.s;
  for (var r in t) return true;
  if (this.__f || "boolean" == typeof this.u && true === this.u) {
    var i = 2 & this.__$f;
    if (!(o || i || 4 & this.__$f)) return true;
    if (1 & this.__$f) return true;
  } else {
    if (!(o || 4 & this.__$f)) return true;
    if (3 & this.__$f) return true;
  }
  for (var a in e) if ("__source" !== a && e[a] !== this.props[a]) return true;
  for (var l in this.props) if (!(l in e)) return true;
  return false;
};
function Jt(e, t) {
  return zt(function() {
    return g(e, t);
  }, []);
}
function ss(e, t) {
  var n = ne(e);
  n.current = e;
  Mt.__$f |= 4;
  return zt(function() {
    return Y(function() {
      return n.current();
    }, t);
  }, []);
}
var ls = "undefined" == typeof requestAnimationFrame ? setTimeout : function(e) {
  var t = function() {
    clearTimeout(n);
    cancelAnimationFrame(o);
    e();
  }, n = setTimeout(t, 35), o = requestAnimationFrame(t);
};
var us = function(e) {
  queueMicrotask(function() {
    queueMicrotask(e);
  });
};
function cs() {
  qn(function() {
    var e;
    while (e = ei.shift()) Ro.call(e);
  });
}
function fs() {
  if (1 === ei.push(this)) (M.requestAnimationFrame || ls)(cs);
}
function ps() {
  qn(function() {
    var e;
    while (e = ti.shift()) Ro.call(e);
  });
}
function oi() {
  if (1 === ti.push(this)) (M.requestAnimationFrame || us)(ps);
}
function Ho(e, t) {
  var n = ne(e);
  n.current = e;
  var o = Mt;
  it(function() {
    return E(function() {
      this.N = fs;
      if (!(o && 8 & o.__$f)) return n.current();
    }, t);
  }, []);
}

// src/vec.ts
var C = (e, t) => [e[0] + t[0], e[1] + t[1], e[2] + t[2]];
var A = (e, t) => [e[0] - t[0], e[1] - t[1], e[2] - t[2]];
var k = (e, t) => [e[0] * t, e[1] * t, e[2] * t];
var F = (e, t) => e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
var pe = (e, t) => [
  e[1] * t[2] - e[2] * t[1],
  e[2] * t[0] - e[0] * t[2],
  e[0] * t[1] - e[1] * t[0]
];
var We = (e) => Math.hypot(e[0], e[1], e[2]);
var Ve = (e, t) => We(A(e, t));
var ds = (e, t, n) => C(k(e, 1 - n), k(t, n));
function W(e, t = [0, 0, 1]) {
  const n = We(e);
  return n > 1e-12 ? k(e, 1 / n) : t;
}
function Et(e) {
  const t = Math.abs(e[0]) < 0.7 * We(e) ? [1, 0, 0] : [0, 1, 0];
  return W(pe(t, e));
}
function jn(e, t, n) {
  const o = Math.cos(n);
  const r = Math.sin(n);
  return C(C(k(e, o), k(pe(t, e), r)), k(t, F(t, e) * (1 - o)));
}
function Qt([e, t]) {
  return Array.from({ length: 8 }, (n, o) => [
    o & 1 ? t[0] : e[0],
    o & 2 ? t[1] : e[1],
    o & 4 ? t[2] : e[2]
  ]);
}
var st = ([e, t]) => ds(e, t, 0.5);

// src/camera.ts
var Do = Math.PI / 180;
var Un = 89 * Do;
function Zt(e, t, n) {
  const o = W(A(e.target, e.eye), [0, 0, -1]);
  const r = W(pe(o, e.up), Et(o));
  const i = pe(r, o);
  const a = e.height != null && e.height > 0;
  const l = a ? e.height / n : 2 * Math.tan(e.fov * Do * 0.5) / n;
  return { eye: e.eye, forward: o, side: r, up: i, width: t, height: n, pixel: l, parallel: a };
}
function Bn(e, t) {
  const n = A(t, e.eye);
  const o = F(n, e.forward);
  const r = e.parallel ? e.pixel : e.pixel * o;
  return [e.width / 2 + F(n, e.side) / r, e.height / 2 - F(n, e.up) / r, o];
}
function Ol(e, t, n) {
  const o = (t - e.width / 2) * e.pixel;
  const r = (e.height / 2 - n) * e.pixel;
  const i = C(k(e.side, o), k(e.up, r));
  if (e.parallel) return { origin: C(e.eye, i), direction: e.forward };
  return { origin: e.eye, direction: W(C(e.forward, i)) };
}
function Fl(e, t) {
  return e.parallel ? e.pixel : e.pixel * Math.max(F(A(t, e.eye), e.forward), 1e-3);
}
function ri(e, t, n, o) {
  const r = A(e.target, e.eye);
  const i = Math.max(We(r), 1e-3);
  const a = Math.asin(Math.max(-1, Math.min(1, F(W(r), t))));
  const l = A(r, k(t, F(r, t)));
  const p = W(We(l) > 1e-6 * i ? l : A(e.up, k(t, F(e.up, t))), Et(t));
  const c = Math.max(-Un, Math.min(Un, a + o));
  const u = jn(p, t, n);
  const d = C(k(u, Math.cos(c)), k(t, Math.sin(c)));
  return { ...e, up: t, target: C(e.eye, k(d, i)) };
}
function ii(e, t, n, o, r) {
  const i = A(e.target, e.eye);
  const a = A(i, k(t, F(i, t)));
  const l = W(We(a) > 1e-6 ? a : e.up, Et(t));
  const p = W(pe(l, t));
  const c = C(C(k(l, n), k(p, o)), k(t, r));
  return je(e, c);
}
function ai(e, t, n, o, r) {
  const i = W(A(e.target, e.eye));
  const a = W(pe(i, e.up), Et(i));
  return je(e, C(C(k(i, n), k(a, o)), k(t, r)));
}
function je(e, t) {
  return { ...e, eye: C(e.eye, t), target: C(e.target, t) };
}
function si(e, t, n, o, r) {
  const i = W(A(e.target, e.eye));
  const a = Math.asin(Math.max(-1, Math.min(1, F(i, t))));
  const l = Math.max(-Un, Math.min(Un, a + r));
  const p = W(pe(i, t), W(pe(i, e.up), Et(i)));
  const c = (u) => jn(jn(u, p, l - a), t, o);
  return {
    ...e,
    up: t,
    eye: C(n, c(A(e.eye, n))),
    target: C(n, c(A(e.target, n)))
  };
}
function li(e, t, n, o, r) {
  const i = t.parallel ? t.pixel : t.pixel * r;
  return je(e, C(k(t.side, -n * i), k(t.up, o * i)));
}
function zn(e, t, n, o, r) {
  const i = A(t, e.eye);
  const a = We(i);
  if (a < 1e-9) return e;
  let l = a * (1 - n);
  if (r) l = Math.sign(l) * Math.max(Math.abs(l), 0.5 * Math.abs(1 - n));
  else if (l > 0) l = Math.max(0, Math.min(l, a - o));
  return je(e, k(i, l / a));
}
function Gn(e, t, n, o, r) {
  const i = Math.max(0.05, Math.min(1e5, (e.height ?? 1) * r));
  const a = (1 - i / (e.height ?? 1)) * t.pixel;
  const l = C(
    k(t.side, (n - t.width / 2) * a),
    k(t.up, (t.height / 2 - o) * a)
  );
  return { ...je(e, l), height: i };
}
function ui(e, t, n = 0.4) {
  const o = st(t);
  const r = Math.max(Ve(t[0], t[1]) / 2, 0.15);
  const i = W(A(e.eye, e.target));
  if (e.height) {
    const l = F(A(e.eye, o), i);
    return { ...e, eye: C(o, k(i, l)), target: o, height: r * 3 };
  }
  const a = Math.max(1.5 * r / Math.tan(e.fov * Do * 0.5), n + r);
  return { ...e, eye: C(o, k(i, a)), target: o };
}
var ci = ["plan", "ceiling", "north", "east", "south", "west"];
function ms(e) {
  const t = Math.abs(e[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
  const n = W(pe(e, t));
  return { right: W(pe(n, e)), ahead: n };
}
function fi(e, t, n, o) {
  const { right: r, ahead: i } = ms(n);
  const a = st(t);
  const l = (b) => Math.abs(F(A(t[1], t[0]), b));
  const p = {
    plan: { forward: k(n, -1), up: i, side: r, cut: 0.15 },
    ceiling: { forward: n, up: k(i, -1), side: r, cut: 0.35 },
    north: { forward: i, up: n, side: r, cut: 0.25 },
    south: { forward: k(i, -1), up: n, side: r, cut: 0.25 },
    east: { forward: r, up: n, side: i, cut: 0.25 },
    west: { forward: k(r, -1), up: n, side: i, cut: 0.25 }
  };
  const c = p[e];
  const u = l(c.forward);
  const d = 1;
  const v = A(a, k(c.forward, u / 2 + d));
  const f = 1.08 * Math.max(l(c.up), l(c.side) / o, 0.1);
  return { eye: v, target: a, up: c.up, fov: 50, height: f, near: d + u * c.cut };
}
function en(e, t) {
  const n = (r, i) => Ve(r, i) < 1e-4;
  const o = (r, i) => Math.abs((r ?? -1) - (i ?? -1)) < 1e-4;
  return n(e.eye, t.eye) && n(e.target, t.target) && n(e.up, t.up) && o(e.fov, t.fov) && o(e.height, t.height) && o(e.near, t.near);
}

// src/counters.ts
var pi = 1024;
var re = {
  frame: 0,
  seqApplied: 0,
  frames: [],
  sent: [],
  entered: 0,
  firstDrawn: 0
};
var di = 0;
for (const e of ["input", "pointermove", "pointerdown", "keydown", "wheel"]) {
  addEventListener(e, (t) => di = t.timeStamp, { capture: true, passive: true });
}
function mi(e, t) {
  re.sent.push({ seq: e, what: t, at: performance.now(), input: di });
  if (re.sent.length > pi) re.sent.shift();
}
function hi(e) {
  re.frame = e.frame;
  re.seqApplied = e.seq;
  re.firstDrawn ||= e.drawn;
  re.frames.push(e);
  if (re.frames.length > pi) re.frames.shift();
  requestAnimationFrame(() => {
    const t = new MessageChannel();
    t.port1.onmessage = () => {
      e.painted = performance.now();
      t.port1.close();
    };
    t.port2.postMessage(0);
  });
}
window.__desk = re;

// src/store.ts
var Xn = /* @__PURE__ */ new Set();
var Pt = (e) => typeof e === "object" && e !== null && !Array.isArray(e);
function on(e, t) {
  if (!Pt(e) || !Pt(t)) return t;
  const n = { ...e };
  for (const [o, r] of Object.entries(t)) n[o] = on(n[o], r);
  return n;
}
var tn = class {
  constructor(t) {
    this.server = t;
    this.shown = g(t);
  }
  server;
  shown;
  own = /* @__PURE__ */ new Map();
  /** The server's word. */
  receive(t) {
    this.server = t;
    this.show();
  }
  /** The page's word, until a patch of `seq`; infinite while it is held. */
  keep(t, n) {
    for (const [o, r] of Object.entries(t)) {
      const i = this.shown.peek()[o];
      this.own.set(o, { value: on(i, r), seq: n });
    }
    Xn.add(this);
    this.show();
  }
  /** The hand has let go: these fields wait for a patch of `seq` from now on. */
  settle(t, n) {
    for (const o of Object.keys(t)) {
      const r = this.own.get(o);
      if (r) r.seq = n;
    }
  }
  /** Forgets what the server has followed. */
  release(t) {
    let n = false;
    for (const [o, r] of this.own) {
      if (r.seq <= t) n = this.own.delete(o) || n;
    }
    if (this.own.size === 0) Xn.delete(this);
    if (n) this.show();
  }
  show() {
    if (this.own.size === 0) {
      this.shown.value = this.server;
      return;
    }
    const t = {};
    for (const [n, o] of this.own) t[n] = o.value;
    this.shown.value = { ...this.server, ...t };
  }
};
var Se = class {
  /** Numbers of the entries there are, ascending; changes only when one comes or goes. */
  ids = g([]);
  entries = /* @__PURE__ */ new Map();
  get(t) {
    if (t == null) return void 0;
    const n = this.entries.get(t);
    if (n) return n.shown.value;
    void this.ids.value;
    return void 0;
  }
  entry(t) {
    return this.entries.get(t);
  }
  /** All entries; whoever asks inside of an effect hears of each change. */
  all() {
    return this.ids.value.map((t) => [t, this.entries.get(t).shown.value]);
  }
  whole(t) {
    const n = /* @__PURE__ */ new Map();
    for (const [o, r] of Object.entries(t ?? {})) n.set(Number(o), new tn(r));
    this.entries = n;
    this.number();
  }
  patch(t) {
    let n = false;
    for (const [o, r] of Object.entries(t)) {
      const i = Number(o);
      const a = this.entries.get(i);
      if (r === null) n = this.entries.delete(i) || n;
      else if (a) a.receive(r);
      else {
        this.entries.set(i, new tn(r));
        n = true;
      }
    }
    if (n) this.number();
  }
  number() {
    this.ids.value = [...this.entries.keys()].sort((t, n) => t - n);
  }
};
var S = new Se();
var ke = new Se();
var le = new Se();
var rn = new Se();
var Ue = new Se();
var an = new Se();
var Be = new Se();
var Tt = new Se();
var nn = {
  lamps: S,
  groups: ke,
  things: le,
  materials: rn,
  views: Ue,
  looks: an,
  meters: Be,
  grids: Tt
};
var J = g(null);
var Yn = g([]);
var lt = g([]);
var $e = g({ undo: null, redo: null, steps: 0 });
var ut = g({ state: "clean", file: "" });
var Z = g({ you: true, name: null });
var Le = g(null);
var Jn = new tn({
  ev: 0,
  metered: null,
  tone: "filmic",
  white: { kelvin: 6500, tint: 0 },
  false_color: null
});
var ct = Jn.shown;
var Ko = {
  scene: J,
  layers: Yn,
  solo: lt,
  history: $e,
  saved: ut,
  editor: Z,
  status: Le
};
function vi(e) {
  Xn.clear();
  for (const [t, n] of Object.entries(nn)) n.whole(e[t]);
  for (const [t, n] of Object.entries(Ko)) if (t in e) n.value = e[t];
  if (Pt(e.display)) Jn.receive(e.display);
}
function gi(e, t) {
  for (const [n, o] of Object.entries(e)) {
    if (n in nn) nn[n].patch(o);
    else if (n === "display") Jn.receive(o);
    else if (n in Ko) Ko[n].value = o;
  }
  Vt(t);
}
function Vt(e) {
  for (const t of [...Xn]) t.release(e);
}
function bi(e, t) {
  for (const [n, o] of Object.entries(e)) {
    if (n in nn && Pt(o)) {
      for (const [r, i] of Object.entries(o)) {
        const a = nn[n].entry(Number(r));
        if (a && Pt(i)) t(a, i);
      }
    } else if (n === "display" && Pt(o)) {
      t(Jn, o);
    }
  }
}
var No = (e, t) => bi(e, (n, o) => n.keep(o, t));
var Qn = (e, t) => bi(e, (n, o) => n.settle(o, t));
function sn(e) {
  const t = ke.get(e.group);
  const n = e.on && !e.parked && (t?.on ?? true);
  return n ? e.level * (t?.level ?? 1) : 0;
}
var yi = Y(() => {
  const e = S.all();
  return e.length > 0 && e.every(([, t]) => sn(t) === 0);
});

// src/wire.ts
var j = g("entering");
var cn = g(0);
var me = g("edit");
var Wo = g(null);
var Ae = g(0);
var _i = () => null;
var ki = (e) => void (_i = e);
var Fo = /* @__PURE__ */ new Map();
var ze = null;
var ln = 0;
var Oo = null;
var un = 0;
var $t = "";
var Zn = false;
function Me(e, t) {
  const n = Fo.get(e) ?? /* @__PURE__ */ new Set();
  Fo.set(e, n.add(t));
  return () => n.delete(t);
}
function D(e) {
  if (!ze || ze.readyState !== WebSocket.OPEN || j.peek() !== "open") return 0;
  ln += 1;
  ze.send(JSON.stringify({ ...e, seq: ln }));
  if (e.do !== "ack") mi(ln, e.do);
  return ln;
}
var hs = 0;
function he(e, t, n) {
  const o = ++hs;
  const r = Me("answer", (i) => {
    if (i.id !== o) return;
    if (i.done !== false) r();
    n(i);
  });
  if (!D({ do: "ask", id: o, what: e, ...t })) r();
  return r;
}
function vs(e) {
  switch (e.is) {
    case "hello":
      un = 0;
      if (Oo !== null && e.build !== Oo) {
        j.value = "renewed";
        ze?.close();
        return;
      }
      Oo = e.build;
      me.value = e.role === "watch" ? "watch" : "edit";
      Wo.value = e.you ?? null;
      Ae.value = 0;
      j.value = "open";
      break;
    case "state":
      vi(e.state ?? e);
      break;
    case "patch":
      qo(e.seq);
      gi(e.patch ?? {}, Ae.value);
      break;
    case "status":
      Le.value = e;
      break;
    case "refused":
      qo(e.seq);
      Vt(Ae.value);
      break;
    case "event":
      if (e.what === "bye") Zn = true;
      break;
  }
  for (const t of [...Fo.get(e.is) ?? []]) t(e);
}
function qo(e) {
  if (typeof e === "number" && e > Ae.value) Ae.value = e;
}
async function wi() {
  if (!$t) return "in";
  try {
    const e = await fetch("/enter", {
      method: "POST",
      headers: { "content-type": "application/json" },
      body: JSON.stringify({ key: $t })
    });
    return e.ok ? "in" : "denied";
  } catch {
    return "away";
  }
}
function xi() {
  const e = location.protocol === "https:" ? "wss" : "ws";
  const t = new WebSocket(`${e}://${location.host}/wire`);
  t.binaryType = "arraybuffer";
  let n = false;
  ze = t;
  t.onmessage = (o) => {
    if (t !== ze) return;
    if (typeof o.data !== "string") {
      const i = _i(o.data);
      if (i) qo(i.seq);
      return;
    }
    const r = JSON.parse(o.data);
    if (r.is === "hello") {
      n = true;
      ln = 0;
    }
    vs(r);
  };
  t.onclose = () => {
    if (t !== ze) return;
    ze = null;
    if (j.value !== "renewed") void gs(n);
  };
}
async function gs(e) {
  Vt(Infinity);
  if (!e && await bs()) {
    const o = await wi();
    if (o === "denied" || o === "in" && un > 4 && !$t) {
      j.value = "denied";
      return;
    }
  }
  un += 1;
  const t = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
  if (un > 3 && t) Zn = true;
  j.value = Zn ? "ended" : "lost";
  const n = Math.min(5, un);
  for (let o = n; o > 0; o--) {
    cn.value = o;
    await new Promise((r) => setTimeout(r, 1e3));
  }
  cn.value = 0;
  xi();
}
async function bs() {
  try {
    return (await fetch("/", { method: "HEAD", cache: "no-store" })).ok;
  } catch {
    return false;
  }
}
async function Si() {
  const e = location.hash.slice(1);
  if (e) {
    $t = e;
    sessionStorage.setItem("lampyris-key", $t);
    window.history.replaceState(null, "", location.pathname + location.search);
  } else {
    $t = sessionStorage.getItem("lampyris-key") ?? "";
  }
  re.entered = performance.now();
  if (e && await wi() === "denied") {
    j.value = "denied";
    return;
  }
  xi();
}
Me("hello", () => Zn = false);

// src/frames.ts
var G = g(null);
var At = g(0);
var Mi = ["moving", "settled", "final"];
var Ci = 32;
var Lt = /* @__PURE__ */ new Map();
var Ce = null;
var jo = null;
var Uo = false;
var ft = null;
function ys(e) {
  if (e.byteLength < Ci) return null;
  const t = new DataView(e);
  const n = {
    frame: t.getUint32(0, true),
    seq: t.getUint32(4, true),
    camera: t.getUint32(8, true),
    width: t.getUint16(12, true),
    height: t.getUint16(14, true),
    kind: Mi[Math.min(t.getUint8(16), 2)],
    falseColor: (t.getUint8(18) & 1) === 1,
    batches: t.getUint32(20, true),
    error: t.getFloat32(24, true),
    light: t.getUint16(28, true) / 10,
    encode: t.getUint16(30, true) / 10
  };
  return { head: n, mime: t.getUint8(17) === 1 ? "image/png" : "image/jpeg" };
}
function _s(e) {
  const t = ys(e);
  if (!t) return null;
  if (ft) D({ do: "ack", frame: ft.head.frame });
  ft = { ...t, bytes: e, received: performance.now() };
  if (!Uo) void ks();
  return t.head;
}
async function ks() {
  Uo = true;
  while (ft) {
    const { head: e, mime: t, bytes: n, received: o } = ft;
    ft = null;
    try {
      const r = await createImageBitmap(new Blob([new Uint8Array(n, Ci)], { type: t }));
      ws(e, r, n.byteLength, o);
    } catch {
    }
    D({ do: "ack", frame: e.frame });
  }
  Uo = false;
}
function ws(e, t, n, o) {
  const r = performance.now();
  if (Ce && jo) {
    if (Ce.width !== t.width || Ce.height !== t.height) {
      Ce.width = t.width;
      Ce.height = t.height;
    }
    jo.drawImage(t, 0, 0);
  }
  t.close();
  const i = Lt.get(e.camera) ?? G.peek()?.camera;
  if (i) G.value = { head: e, camera: i };
  xs();
  hi({
    frame: e.frame,
    seq: e.seq,
    kind: Mi.indexOf(e.kind),
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
var eo = [];
function xs() {
  const e = performance.now();
  eo = eo.filter((t) => e - t < 1e3);
  eo.push(e);
  At.value = eo.length;
}
function Bo(e) {
  Ce = e;
  jo = e?.getContext("2d", { alpha: false }) ?? null;
}
function Ei() {
  if (!Ce || !G.peek()) return null;
  const e = document.createElement("canvas");
  e.width = Ce.width;
  e.height = Ce.height;
  e.getContext("2d", { alpha: false })?.drawImage(Ce, 0, 0);
  return e;
}
ki(_s);
Me("camera", (e) => {
  Lt.set(e.number, e);
  for (const t of Lt.keys()) {
    if (Lt.size <= 64) break;
    Lt.delete(t);
  }
});
Me("hello", () => {
  Lt.clear();
  ft = null;
});

// src/say.ts
var pt = g([]);
var Ss = 0;
function q(e, t = "plain") {
  const n = pt.peek().find((r) => r.text === e);
  if (n) return;
  const o = ++Ss;
  pt.value = [...pt.peek().slice(-2), { id: o, text: e, tone: t }];
  setTimeout(() => zo(o), t === "warn" ? 8e3 : 4e3);
}
function zo(e) {
  pt.value = pt.peek().filter((t) => t.id !== e);
}

// src/gesture.ts
var It = 0;
var Ti = /* @__PURE__ */ new Set();
var Vi = (e) => void Ti.add(e);
var fn = /* @__PURE__ */ new Set();
function ie() {
  if (j.value !== "open") return "There is no connection to the program: nothing was changed.";
  if (me.value === "watch") return "You are watching. Ask for the pen to change things.";
  if (!Z.value.you) return `${Z.value.name ?? "Somebody else"} has the pen. Take it to change things.`;
  return null;
}
var dt = class {
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
    if (this.state === "over" || !this.begin()) return;
    No(t, Infinity);
    this.touched = on(this.touched, t);
    this.waiting = on(this.waiting ?? {}, t);
    if (this.under <= Ae.peek()) this.flush();
  }
  /** Any other message that belongs to this step. */
  also(t) {
    if (this.state === "over" || !this.begin()) return;
    this.flush();
    this.last = D(t);
  }
  end(t) {
    if (this.state === "held") {
      this.flush();
      Qn(this.touched, this.last);
      this.finish({ do: "end", ...t ? { label: t } : {} });
    }
    this.state = "over";
  }
  cancel() {
    if (this.state === "held") {
      this.waiting = null;
      Qn(this.touched, 0);
      this.finish({ do: "cancel" });
      Vt(0);
    }
    this.state = "over";
  }
  /** The server has followed so far. */
  followed() {
    if (this.waiting && this.under <= Ae.peek()) this.flush();
  }
  /** The line is gone, and with it what was held. */
  drop() {
    this.state = "over";
    fn.delete(this);
    It = 0;
  }
  begin() {
    if (this.state === "held") return true;
    const t = oe(ie);
    if (t) {
      q(t, "warn");
      this.state = "over";
      return false;
    }
    this.state = "held";
    fn.add(this);
    if (It === 0) Ti.forEach((n) => n());
    if (It++ === 0) this.last = D({ do: "begin", label: this.label });
    return true;
  }
  flush() {
    if (!this.waiting) return;
    this.under = this.last = D({ do: "set", patch: this.waiting });
    this.waiting = null;
  }
  finish(t) {
    fn.delete(this);
    It = Math.max(0, It - 1);
    if (It === 0) D(t);
  }
};
function ue(e, t) {
  const n = new dt(e);
  n.set(t);
  n.end();
}
function to(e, t) {
  const n = new dt(e);
  n.also(t);
  n.end();
}
function Ie(e) {
  if (oe(() => j.value) !== "open") return;
  No({ display: e }, Infinity);
  Qn({ display: e }, D({ do: "display", patch: e }));
}
var Ee = null;
function au(e, t, n) {
  if (Ee && Ee.key !== e) Pi();
  Ee ??= { key: e, gesture: new dt(t), timer: 0 };
  Ee.gesture.set(n);
  clearTimeout(Ee.timer);
  Ee.timer = window.setTimeout(Pi, 700);
}
function Pi() {
  if (!Ee) return;
  clearTimeout(Ee.timer);
  Ee.gesture.end();
  Ee = null;
}
E(() => {
  void Ae.value;
  oe(() => [...fn].forEach((e) => e.followed()));
});
E(() => {
  if (j.value !== "open") [...fn].forEach((e) => e.drop());
});

// src/before.ts
var no = g(null);
var ve = g(null);
var du = g(0.5);
function Ms() {
  const e = G.peek();
  const t = Ei();
  if (e && t) no.value = { picture: t, camera: e.camera };
}
Vi(() => {
  if (ve.peek() !== "wipe") Ms();
});
function $i() {
  const e = no.peek();
  const t = G.peek();
  if (!e || !t) q("Nothing has been changed yet.");
  else if (!en(e.camera, t.camera)) q("The picture before was taken from another place: go back there with Alt+←.", "warn");
  else return true;
  return false;
}
function Rt(e) {
  if (!e) {
    if (ve.peek() === "held") ve.value = null;
  } else if (ve.peek() === null && $i()) ve.value = "held";
}
function Li() {
  ve.value = ve.peek() === "wipe" ? null : $i() ? "wipe" : null;
}

// src/select.ts
var K = g(null);
var mt = g(null);
var N = g(null);
var Go = g("move");
var ee = Y(() => {
  const e = K.value;
  if (e?.kind === "lamp") return e.ids.filter((t) => S.get(t));
  if (e?.kind === "group") return e.ids.flatMap((t) => ke.get(t)?.lamps ?? []);
  return [];
});
function ht(e, t, n = "only") {
  const o = K.peek();
  if (n === "only" || o?.kind !== e) {
    K.value = { kind: e, ids: [t] };
    return;
  }
  const r = o.ids.includes(t);
  if (r && n === "add") return;
  const i = r ? o.ids.filter((a) => a !== t) : [...o.ids, t];
  K.value = i.length ? { kind: e, ids: i } : null;
}
function pn() {
  K.value = null;
}
function gu(e, t, n) {
  const o = K.peek();
  const r = o?.kind === e ? t.indexOf(o.ids[o.ids.length - 1]) : -1;
  if (r < 0) return ht(e, n);
  const i = t.indexOf(n);
  const [a, l] = r < i ? [r, i] : [i, r];
  const p = t.slice(a, l + 1);
  const c = (o?.ids ?? []).filter((u) => !p.includes(u));
  K.value = { kind: e, ids: [...c, ...r < i ? p : p.reverse()] };
}
function Xo(e) {
  const t = K.peek();
  const n = t?.kind ?? "lamp";
  const o = n === "lamp" ? S.ids.peek() : n === "thing" ? le.ids.peek() : ke.ids.peek();
  if (!o.length) return;
  const r = t ? o.indexOf(t.ids[t.ids.length - 1]) : e > 0 ? -1 : 0;
  ht(n, o[(r + e + o.length) % o.length]);
}
function Cs(e, t) {
  switch (e) {
    case "lamp":
      return S.get(t)?.name ?? `lamp ${t}`;
    case "group":
      return ke.get(t)?.name ?? `group ${t}`;
    case "thing":
      return le.get(t)?.name ?? `thing ${t}`;
    case "material":
      return rn.get(t)?.name ?? `material ${t}`;
    default:
      return `${e} ${t}`;
  }
}
function Ge(e) {
  return e.length === 1 ? Cs("lamp", e[0]) : `${e.length} lamps`;
}
function Ai(e, t) {
  const n = [];
  if (e?.lamp != null) {
    n.push({ kind: "lamp", ids: [e.lamp] });
    const i = S.get(e.lamp)?.group;
    if (i != null && (ke.get(i)?.lamps.length ?? 0) > 1) n.push({ kind: "group", ids: [i] });
  }
  if (e?.thing != null) n.push({ kind: "thing", ids: [e.thing] });
  if (!n.length) {
    if (t === "only") pn();
    return;
  }
  if (t !== "only") return ht(n[0].kind, n[0].ids[0], t);
  const o = K.peek();
  const r = n.findIndex((i) => o?.kind === i.kind && o.ids.length === 1 && o.ids[0] === i.ids[0]);
  K.value = n[(r + 1) % n.length];
}
var Re = g(null);

// src/highlight.ts
function oo(e) {
  lt.value = e;
  D({ do: "solo", lamps: e });
}
function Es(e) {
  const t = lt.peek();
  const n = e.every((o) => t.includes(o));
  oo(n ? t.filter((o) => !e.includes(o)) : [...t, ...e.filter((o) => !t.includes(o))]);
}
var Ii = () => Es(ee.peek());
var ro = () => oo([]);
var dn = null;
function mn(e) {
  if (e && dn === null && ee.peek().length) {
    dn = lt.peek();
    oo(ee.peek());
  } else if (!e && dn !== null) {
    oo(dn);
    dn = null;
  }
}

// src/prefs.ts
var Ri = "lampyris-";
function ce(e, t) {
  let n = t;
  try {
    const r = localStorage.getItem(Ri + e);
    if (r !== null) n = JSON.parse(r);
  } catch {
  }
  const o = g(n);
  E(() => {
    const r = JSON.stringify(o.value);
    try {
      localStorage.setItem(Ri + e, r);
    } catch {
    }
  });
  return o;
}
var Xe = ce("theme", "dark");
var Ht = ce("house-lights", 1);
var hn = ce("hands", "default");
var Ye = ce("walking", "walk");
var vn = ce("panels", true);
var Yo = ce("listing", "faders");
var Jo = ce("travel", "square");
var Je = ce("candles", "lx");
var Hi = ce("single-keys", true);
var gn = ce("lamp-marks", true);
var Su = ce("maintenance", 1);
var Pe = ce("fine", false);
var Di = ce("fade", 1);
var Ps = typeof matchMedia === "function" && matchMedia("(pointer: coarse)").matches;
var ge = ce("look-only", Ps);

// src/navigate.ts
var Ts = 1.6;
var be = g(null);
var He = Y(() => J.value?.up ?? [0, 0, 1]);
var we = g([640, 480]);
var vt = g(null);
var Zo = null;
var yn = null;
var Qo = false;
var Qe = [];
var tr = [];
var er = 0;
function O(e, t = null) {
  const n = be.peek();
  if (n && en(n, e)) return;
  const o = performance.now();
  if (n && (o - er > 1e3 || t)) {
    Qe.push(n);
    if (Qe.length > 100) Qe.shift();
    tr.length = 0;
  }
  er = o;
  be.value = e;
  vt.value = t;
}
var te = () => be.peek();
function Ni() {
  Fi(Qe, tr);
}
function Oi() {
  Fi(tr, Qe);
}
function Fi(e, t) {
  const n = e.pop();
  if (!n) return;
  const o = be.peek();
  if (o) t.push(o);
  er = performance.now();
  be.value = n;
  vt.value = null;
}
E(() => {
  const e = be.value;
  if (!e || j.value !== "open" || me.value === "watch" || Qo) return;
  Qo = true;
  requestAnimationFrame(() => {
    Qo = false;
    const t = be.peek();
    if (!t || yn && en(yn, t)) return;
    const { eye: n, target: o, up: r, fov: i, height: a, near: l } = t;
    const p = { do: "camera", eye: n, target: o, up: r, fov: i };
    if (a) p.height = a;
    if (l) p.near = l;
    if (D(p)) yn = t;
  });
});
E(() => {
  const e = G.value;
  if (!e) return;
  oe(() => {
    if (be.peek() && me.peek() === "edit") return;
    yn = e.camera;
    be.value = e.camera;
    Zo ??= e.camera;
  });
});
Me("hello", () => yn = null);
function Dt(e, t) {
  const n = G.peek();
  if (!n) return null;
  const { head: o } = n;
  const r = io(o.width, o.height);
  return { frame: o.frame, x: (e - r.x) / r.scale, y: (t - r.y) / r.scale };
}
function io(e, t) {
  const [n, o] = we.peek();
  const r = Math.min(n / e, o / t);
  return { x: (n - e * r) / 2, y: (o - t * r) / 2, scale: r };
}
function gt(e = be.peek()) {
  const [t, n] = we.peek();
  return e ? Zt(e, t, n) : null;
}
var _n = () => J.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]];
var Kt = () => st(_n());
function ao(e, t) {
  const n = te();
  if (n) O(ri(n, He.peek(), e, t));
}
function so(e, t, n) {
  const o = te();
  if (o) O(si(o, He.peek(), e, t, n));
}
function Nt(e, t, n) {
  const o = te();
  const r = gt();
  if (o && r) O(li(o, r, e, t, n));
}
function qi(e, t, n) {
  const o = te();
  if (!o) return;
  if (o.height) {
    const r = gt(o);
    if (r) O(je(o, C(k(r.side, t), k(r.up, e))));
    return;
  }
  if (Ye.peek() === "fly" || n !== 0) O(ai(o, He.peek(), e, t, n));
  else {
    O(ii(o, He.peek(), e, t, 0));
    Vs();
  }
}
var bn = false;
var Ki = null;
function Vs() {
  const e = te();
  if (!e || bn) return;
  const t = He.peek();
  bn = true;
  const n = he("ray", { origin: e.eye, direction: k(t, -1) }, (o) => {
    bn = false;
    const r = te();
    if (!o.hit || !r || r.height) return;
    Ki = F(o.point, t);
    const i = Ki + Ts - F(r.eye, t);
    if (Math.abs(i) > 0.01) O(je(r, k(t, i * 0.5)));
  });
  setTimeout(() => {
    if (bn) n();
    bn = false;
  }, 500);
}
function $s() {
  const e = K.peek();
  if (!e) return null;
  const t = [];
  const n = (i, a) => {
    if (i) t.push(i);
    else if (a) t.push([a, a]);
  };
  for (const i of e.ids) {
    if (e.kind === "lamp") n(S.get(i)?.box, S.get(i)?.place?.position);
    if (e.kind === "thing") n(le.get(i)?.box);
    if (e.kind === "meter") n(null, Be.get(i)?.point);
    if (e.kind === "group") {
      for (const a of ke.get(i)?.lamps ?? []) n(S.get(a)?.box, S.get(a)?.place?.position);
    }
  }
  if (!t.length) return null;
  const o = t.flatMap(Qt);
  const r = (i) => [0, 1, 2].map((a) => i(...o.map((l) => l[a])));
  return [r(Math.min), r(Math.max)];
}
function lo() {
  const e = te();
  const t = $s();
  if (e && t) O(ui(e, t), "selection");
  else uo();
}
function uo() {
  if (Zo) O(Zo, "home");
}
function Wi(e) {
  const [t, n] = we.peek();
  O(fi(e, _n(), He.peek(), t / n), e);
}
function ji() {
  for (let e = Qe.length - 1; e >= 0; e--) {
    if (!Qe[e].height) return O(Qe[e], "inside");
  }
  uo();
}
var Ui = Y(() => {
  const e = be.value;
  if (!e?.height) return null;
  const t = Zt(e, 2, 2);
  const n = Qt(_n()).map((o) => F(A(o, e.eye), t.forward));
  return { value: e.near ?? 0, most: Math.max(...n) };
});
function Bi(e) {
  const t = te();
  if (t) be.value = { ...t, near: Math.max(0, e) };
}

// src/tools.ts
var wn = g("spot");
var kn = null;
function De(e) {
  kn = null;
  N.value = N.peek() === e ? null : e;
}
function Gi(e) {
  if (!e) return q("There is nothing at that point.", "warn");
  switch (N.peek()) {
    case "aim":
      nr(ee.peek(), e.point);
      N.value = null;
      break;
    case "meter":
      rr(e.point, e.normal);
      N.value = null;
      break;
    case "grid":
      if (!kn) {
        kn = e;
        return;
      }
      As(kn.point, e.point);
      kn = null;
      N.value = null;
      break;
    case "add":
      Is(wn.peek(), e);
      N.value = null;
      break;
  }
}
function nr(e, t) {
  const n = {};
  for (const o of e) {
    const r = S.get(o)?.place;
    if (!r?.position || !r.direction) continue;
    n[o] = { place: { aim: t, direction: W(A(t, r.position)) } };
  }
  if (!Object.keys(n).length) return q("What is selected shines into all directions: it cannot be aimed.", "warn");
  ue(`Aim ${Ge(e)}`, { lamps: n });
}
function or(e, t) {
  const n = new Set(e.ids.peek());
  const o = e.ids.subscribe((r) => {
    const i = r.filter((a) => !n.has(a));
    if (!i.length) return;
    ht(t, i[i.length - 1]);
    queueMicrotask(() => o());
  });
  setTimeout(() => o(), 3e3);
}
var xn = (e) => Math.max(-1, ...e.ids.peek()) + 1;
function rr(e, t) {
  const n = xn(Be);
  or(Be, "meter");
  ue("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function Ls(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
function As(e, t, n = { lux: 500, uniformity: 0.6 }) {
  const o = He.peek();
  const r = Math.abs(o[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
  const i = W(pe(o, r));
  const a = A(t, e);
  let [l, p] = [F(a, r), F(a, i)];
  if (Math.abs(l) < 0.05 || Math.abs(p) < 0.05) return q("An area needs two corners that lie apart.", "warn");
  const c = C(e, C(k(r, Math.min(l, 0)), k(i, Math.min(p, 0))));
  [l, p] = [Math.abs(l), Math.abs(p)];
  const u = (v) => Math.max(1, Math.ceil(v / Ls(Math.max(l, p))));
  const d = xn(Tt);
  or(Tt, "grid");
  ue("Lay a grid", {
    grids: {
      [d]: {
        name: `Area ${d + 1}`,
        corner: c,
        u: k(r, l),
        v: k(i, p),
        normal: o,
        columns: u(l),
        rows: u(p),
        target: n
      }
    }
  });
}
var zi = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function Is(e, t) {
  const n = He.peek();
  const o = F(t.normal, n);
  const r = o > 0.7 ? C(t.point, k(n, 1.2)) : C(t.point, k(t.normal, 0.15));
  const i = o > 0.7 || o < -0.7 ? k(n, -1) : t.normal;
  const a = { position: r };
  if (e !== "point" && e !== "sphere") a.direction = i;
  if (e === "spot") Object.assign(a, { inner: 24, outer: 36, aim: o > 0.7 ? t.point : null });
  if (e === "disc") a.radius = 0.15;
  if (e === "sphere") a.radius = 0.08;
  const l = S.all().filter(([, p]) => p.own).length;
  or(S, "lamp");
  to(`Add ${zi[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: {
      name: `${zi[e] ?? e} ${l + 1}`,
      kind: e,
      on: true,
      level: 1,
      flux: 800,
      color: { mode: "kelvin", kelvin: 3e3, tint: 0, rgb: [1, 1, 1], xy: [0.4369, 0.4041] },
      place: a
    }
  });
}
function Xi(e, t, n) {
  if (!e.length || t < 1) return;
  to(`Copy ${Ge(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function Yi(e) {
  if (e.length) to(`Remove ${Ge(e)}`, { do: "remove", lamps: e });
}
function Rs(e, t, n) {
  const o = {};
  for (const r of e) {
    const i = S.get(r)?.place;
    const a = n.get(r);
    if (!i || !a) continue;
    const l = C(a, t);
    const p = i.aim && Ve(i.aim, l) > 1e-6 ? { direction: W(A(i.aim, l)) } : {};
    o[r] = { place: { position: l, ...p } };
  }
  return { lamps: o };
}
function Hs(e) {
  const t = /* @__PURE__ */ new Map();
  for (const n of e) {
    const o = S.get(n)?.place?.position;
    if (o) t.set(n, o);
  }
  return t;
}
function qu(e, t) {
  const n = new dt(`Move ${Ge(e)}`);
  n.set(Rs(e, t, Hs(e)));
  n.end();
}

// src/actions.ts
var xe = g(null);
var et = g("lamps");
var Qi = g("");
var Ze = () => ie() ?? (ee.value.length ? null : "Select a lamp first.");
function bt(e) {
  const t = ie();
  if (t) q(t, "warn");
  else D(e);
}
function Ds() {
  const e = ee.peek();
  const t = !e.some((n) => S.get(n)?.on);
  ue(`${Ge(e)} ${t ? "on" : "off"}`, { lamps: ar(e, { on: t }) });
}
var ar = (e, t) => Object.fromEntries(e.map((n) => [n, t]));
function Ks() {
  const e = ee.peek();
  const t = !e.every((n) => S.get(n)?.parked);
  ue(`${t ? "Park" : "Unpark"} ${Ge(e)}`, { lamps: ar(e, { parked: t }) });
}
var Ns = {
  quantity: "illuminance",
  low: 1,
  high: 1e3,
  scale: "log",
  palette: "viridis",
  lines: false
};
var ir = Ns;
function sr() {
  const e = ct.peek().false_color;
  if (e) ir = e;
  Ie({ false_color: e ? null : ir });
}
function Sn(e) {
  const t = Math.round((ct.peek().ev + e / 3) * 30) / 30;
  Ie({ ev: t });
}
function Ji(e) {
  const t = K.peek();
  const n = e ? t?.kind === "thing" ? t.ids : [] : le.ids.peek().filter((o) => le.get(o)?.hidden);
  if (!n.length) return q(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  ue(e ? "Hide things" : "Show hidden things", { things: ar(n, { hidden: e }) });
}
function lr() {
  const e = te();
  if (!e) return;
  const t = xn(Ue);
  ue("Store the view", { views: { [t]: { ...e, name: `View ${t + 1}` } } });
}
var Os = () => bt({ do: "look", what: "store", name: `Look ${xn(an) + 1}` });
function Fs() {
  const e = ee.peek()[0];
  const t = S.get(e)?.place;
  const n = te();
  if (!t?.position || !t.direction || !n) return q("Select a lamp that has a direction.", "warn");
  const { position: o, direction: r } = t;
  O({ ...n, eye: o, target: [o[0] + r[0], o[1] + r[1], o[2] + r[2]], height: null, near: null }, "from the lamp");
}
function qs() {
  he("command", {}, (e) => void ur(e.text));
}
async function ur(e) {
  let t = false;
  try {
    await navigator.clipboard.writeText(e);
    t = true;
  } catch {
    const n = document.createElement("textarea");
    n.value = e;
    n.className = "spoken";
    document.body.append(n);
    n.select();
    t = document.execCommand("copy");
    n.remove();
  }
  q(t ? "Copied." : `Copy it by hand: ${e}`);
}
var Ws = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]];
var js = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
};
var Mn = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: lo },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: uo },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: ji },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: Ni },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: Oi },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: lr, why: ie },
  ...ci.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: js[e],
    keys: `Shift+${t + 1}`,
    run: () => Wi(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      Ye.value = Ye.peek() === "walk" ? "fly" : "walk";
      q(Ye.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: Fs, why: Ze },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => Xo(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => Xo(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => De("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => K.value = { kind: "lamp", ids: S.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: pn },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: Ds, why: Ze },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Ii, why: () => ee.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: ro },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => mn(true), why: Ze },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Ks, why: Ze },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => De("aim"), why: Ze },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => Re.peek() && nr(ee.peek(), Re.peek().point), why: Ze },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => Go.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => Go.value = "turn" },
  ...Ws.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: ie,
    run: () => {
      wn.value = e;
      De("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => Xi(ee.peek(), 1, [0.5, 0, 0]), why: Ze },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => Yi(ee.peek()), why: Ze },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => Ji(true), why: ie },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => Ji(false), why: ie },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => bt({ do: "undo" }), why: () => ie() ?? ($e.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => bt({ do: "redo" }), why: () => ie() ?? ($e.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => xe.value = "save", why: ie },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => xe.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: qs },
  { id: "share", group: "Work", label: "Share by link", run: () => xe.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: sr },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      const e = ct.peek().false_color ?? ir;
      Ie({ false_color: { ...e, quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => Sn(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => Sn(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => D({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => Rt(true) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: Li },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: ie, run: () => Re.peek() ? rr(Re.peek().point, Re.peek().normal) : De("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => De("meter"), why: ie },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => De("grid"), why: ie },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => Je.value = Je.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Os, why: ie },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => q("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => vn.value = !vn.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => Yo.value = Yo.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => Jo.value = Jo.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => gn.value = !gn.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => Pe.value = !Pe.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => Xe.value = Xe.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => ge.value = !ge.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => hn.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => xe.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => xe.value = "palette" }
];
var cr = new Map(Mn.map((e) => [e.id, e]));
function ae(e) {
  const t = cr.get(e);
  const n = t?.why?.();
  if (n) q(n, "warn");
  else t?.run();
}
function Zi(e) {
  return cr.get(e)?.why?.() ?? null;
}
var ea = (e) => cr.get(e)?.keys;
function ta() {
  const e = (J.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t }));
  return [...e, ...Ue.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/units.ts
var co = 0.3048;
var na = {
  level: { bare: 0.01, units: { "%": 0.01, x: 1, "×": 1 }, low: 0, high: 1e3, say: "a level such as 80 % or 450 lm" },
  flux: { bare: 1, units: { lm: 1, klm: 1e3 }, low: 0, high: 1e9, say: "a flux such as 450 lm" },
  kelvin: { bare: 1, units: { k: 1 }, low: 1e3, high: 25e3, say: "a colour temperature such as 2700 K" },
  angle: { bare: 1, units: { "°": 1, deg: 1, rad: 180 / Math.PI }, low: -36e3, high: 36e3, say: "an angle such as 30°" },
  length: {
    bare: 1,
    units: { m: 1, cm: 0.01, mm: 1e-3, km: 1e3, ft: co, "'": co, in: co / 12, '"': co / 12 },
    low: -1e6,
    high: 1e6,
    say: `a length such as 2.4 m, 75 cm or 8'2"`
  },
  lux: { bare: 1, units: { lx: 1, klx: 1e3, fc: 10.7639 }, low: 0, high: 1e9, say: "an illuminance such as 500 lx" },
  share: { bare: 1, units: { "%": 0.01 }, low: 0, high: 1, say: "a share from 0 to 1 or 0 to 100 %" },
  number: { bare: 1, units: {}, low: -1e9, high: 1e9, say: "a number" },
  ev: { bare: 1, units: { ev: 1, stop: 1, stops: 1 }, low: -30, high: 30, say: "an exposure such as 8.3" },
  seconds: { bare: 1, units: { s: 1, ms: 1e-3, min: 60 }, low: 0, high: 3600, say: "a time such as 2 s" }
};
var Us = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;
function fr(e) {
  const t = Us.exec(e);
  if (!t) return null;
  const [n, o] = t[0].split("/").map(Number);
  if (o === 0) return null;
  return { value: o === void 0 ? n : n / o, rest: e.slice(t[0].length).trimStart() };
}
function oa(e, t, n) {
  let o = e.trim();
  let r = 0;
  let i = true;
  while (o) {
    let a = 1;
    const l = /^[+-]\s*/.exec(o);
    if (l && !i) {
      a = o[0] === "-" ? -1 : 1;
      o = o.slice(l[0].length);
    }
    const p = fr(o);
    if (!p) return null;
    const c = /^[a-zµ°%'"×]+/i.exec(p.rest)?.[0] ?? "";
    const u = c === "" ? n : t.units[c.toLowerCase()];
    if (u === void 0) return null;
    r += a * p.value * u;
    o = p.rest.slice(c.length).trim();
    i = false;
  }
  return i ? null : r;
}
function ra(e, t, n) {
  const o = na[t];
  const r = e.trim().replace(/,(?=\d)/g, ".").replace(/[\u2009\u202f\u00a0]/g, "").replace(/−/g, "-");
  const i = { why: `“${e.trim()}” is not ${o.say}` };
  const a = (_) => ({
    apply: (x) => Math.min(o.high, Math.max(o.low, _(x)))
  });
  if (!r) return { why: `Type ${o.say}` };
  const l = r.toLowerCase();
  if (t === "level" && l === "full") return a(() => 1);
  if (t === "level" && (l === "out" || l === "off")) return a(() => 0);
  const p = /^(.*?)\s*(?:stops?|ev)$/i.exec(r);
  if (p && t !== "ev") {
    const _ = fr(p[1].trim());
    if (!_ || _.rest || !["level", "flux", "lux", "number"].includes(t)) return i;
    return a((x) => x * 2 ** _.value);
  }
  const c = /^([*/×÷])\s*(.+)$/.exec(r);
  if (c) {
    const _ = fr(c[2]);
    if (!_) return i;
    const x = _.rest === "%" ? 0.01 : _.rest === "" ? 1 : NaN;
    const w = _.value * x;
    if (!Number.isFinite(w) || w === 0 && /[/÷]/.test(c[1])) return i;
    return a((y) => /[/÷]/.test(c[1]) ? y / w : y * w);
  }
  const u = t === "length" || t === "angle" || t === "ev" || t === "number";
  const d = u ? /^([+-])=\s*(.+)$/.exec(r) : /^([+-])=?\s*(.+)$/.exec(r);
  const v = d ? d[2] : r;
  let f = oa(v, o, o.bare);
  if (f === null && t === "level" && n) {
    const _ = oa(v, { ...na.flux }, NaN);
    f = _ === null || Number.isNaN(_) ? null : _ / n;
  }
  if (f === null || !Number.isFinite(f)) return i;
  const b = f;
  if (d) return a((_) => d[1] === "-" ? _ - b : _ + b);
  if (b < o.low || b > o.high) {
    return { why: `${e.trim()} is out of range: ${o.say}` };
  }
  return a(() => b);
}
function U(e, t = 0) {
  if (!Number.isFinite(e)) return "–";
  const [n, o] = Math.abs(e).toFixed(t).split(".");
  const r = n.length > 4 ? n.replace(/\B(?=(\d{3})+$)/g, " ") : n;
  const i = e < 0 && Number(Math.abs(e).toFixed(t)) !== 0 ? "−" : "";
  return i + r + (o ? `.${o}` : "");
}
function Cn(e) {
  const t = Math.abs(e);
  return U(e, t >= 99.95 || t === 0 ? 0 : t >= 9.995 ? 1 : t >= 0.9995 ? 2 : 3);
}
function Bs(e) {
  const t = e * 100;
  return U(t, t >= 9.95 || t === 0 ? 0 : t >= 0.95 ? 1 : 2);
}
function ia(e, t) {
  switch (t) {
    case "level":
      return `${Bs(e)} %`;
    case "flux":
      return `${Cn(e)} lm`;
    case "kelvin":
      return `${U(e)} K`;
    case "angle":
      return `${U(e, 1)}°`;
    case "length":
      return `${U(e, 2)} m`;
    case "lux":
      return `${Cn(e)} lx`;
    case "seconds":
      return `${U(e, 1)} s`;
    case "ev":
      return U(e, 1);
    case "share":
      return U(e, 2);
    case "number":
      return String(Math.round(e * 1e4) / 1e4);
  }
}
function Ot(e, t = true) {
  const n = Je.value === "fc";
  const o = n ? e / 10.7639 : e;
  return Cn(o) + (t ? n ? " fc" : " lx" : "");
}

// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var zs = /* @__PURE__ */ Symbol.for("pv");
var Gs = 0;
function s(e, t, n, o, r, i) {
  t || (t = {});
  var a, l, p = t;
  if ("ref" in p && "function" != typeof e) for (l in p = {}, t) "ref" == l ? a = t[l] : p[l] = t[l];
  var c = { type: e, props: p, key: n, ref: a, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: zs, __v: --Gs, __i: -1, __u: 0 };
  return (r || i) && (c.__source = r, c.__self = i), M.vnode && M.vnode(c), c;
}

// src/field.tsx
function fo(e) {
  const t = Jt(null);
  const n = Jt(null);
  const o = ne(null);
  const r = ne(null);
  const i = t.value ?? e.text ?? (e.value === null ? "mixed" : ia(e.value, e.quantity));
  it(() => {
    if (!e.open || !o.current) return;
    t.value = e.open;
    o.current.focus();
    o.current.setSelectionRange(e.open.length, e.open.length);
    e.opened?.();
  }, [e.open]);
  const a = () => {
    if (t.value === null) return;
    const d = ra(t.value, e.quantity, e.flux);
    if ("why" in d) {
      n.value = d.why;
      return;
    }
    t.value = null;
    n.value = null;
    e.set(d.apply);
  };
  const l = (d) => {
    if (d.key === "Enter") {
      d.preventDefault();
      a();
      if (t.value === null) o.current?.select();
    } else if (d.key === "Escape") {
      d.stopPropagation();
      if (t.value === null) o.current?.blur();
      t.value = null;
      n.value = null;
    } else if ((d.key === "ArrowUp" || d.key === "ArrowDown") && e.step && t.value === null) {
      d.preventDefault();
      const v = (d.key === "ArrowUp" ? 1 : -1) * e.step * (d.shiftKey ? 10 : d.ctrlKey ? 0.1 : 1);
      e.set((f) => f + v);
    }
  };
  const p = (d) => {
    if (!e.scrub || e.disabled || d.button !== 0 || document.activeElement === o.current) return;
    r.current = { x: d.clientX, last: d.clientX, moved: false };
    o.current?.setPointerCapture(d.pointerId);
    d.preventDefault();
  };
  const c = (d) => {
    const v = r.current;
    if (!v || !e.scrub) return;
    if (!v.moved && Math.abs(d.clientX - v.x) < 4) return;
    if (!v.moved) e.scrub.begin();
    v.moved = true;
    e.scrub.on((d.clientX - v.last) * (e.step ?? 1) * (d.shiftKey ? 0.1 : d.altKey ? 10 : 1));
    v.last = d.clientX;
  };
  const u = (d) => {
    const v = r.current;
    r.current = null;
    if (!v) return;
    if (!v.moved) {
      o.current?.focus();
      o.current?.select();
    } else if (d.type === "pointercancel") e.scrub?.cancel();
    else e.scrub?.end();
  };
  return /* @__PURE__ */ s("span", { class: `field ${n.value ? "wrong" : ""} ${e.scrub ? "scrubs" : ""}`, children: [
    /* @__PURE__ */ s(
      "input",
      {
        ref: o,
        id: e.id,
        type: "text",
        inputMode: "text",
        autoComplete: "off",
        spellcheck: false,
        value: i,
        disabled: e.disabled,
        title: e.why ?? void 0,
        "aria-label": e.label,
        "aria-invalid": n.value ? true : void 0,
        "aria-errormessage": n.value ? `${e.id ?? e.label}-why`.replace(/\s/g, "-") : void 0,
        onInput: (d) => {
          t.value = d.currentTarget.value;
          n.value = null;
        },
        onFocus: (d) => t.value === null && d.currentTarget.select(),
        onBlur: () => {
          a();
          if (n.value) {
            t.value = null;
            setTimeout(() => n.value = null, 4e3);
          }
        },
        onKeyDown: l,
        onPointerDown: p,
        onPointerMove: c,
        onPointerUp: u,
        onPointerCancel: u
      }
    ),
    n.value && /* @__PURE__ */ s("span", { class: "why", role: "alert", id: `${e.id ?? e.label}-why`.replace(/\s/g, "-"), children: n.value })
  ] });
}

// src/icon.tsx
function B({ name: e }) {
  return /* @__PURE__ */ s("svg", { class: "sign", "aria-hidden": "true", width: "16", height: "16", children: /* @__PURE__ */ s("use", { href: `icons.svg#${e}` }) });
}

// src/range.tsx
var aa = -1e9;
addEventListener("scroll", () => aa = performance.now(), { capture: true, passive: true });
var Ft = (e) => Math.max(0, Math.min(1, e));
function po(e) {
  const t = ne(null);
  const n = ne(null);
  const o = e.notch ?? 0.01;
  const r = (c) => {
    if (c.button !== 0 || e.disabled) return;
    const u = c.currentTarget.getBoundingClientRect();
    const d = e.vertical ? (u.bottom - c.clientY - 8) / (u.height - 16) : (c.clientX - u.left - 6) / (u.width - 12);
    const v = c.pointerType !== "touch" && !c.shiftKey;
    n.current = { id: c.pointerId, x: c.clientX, y: c.clientY, at: v ? Ft(d) : e.value };
    t.current?.setPointerCapture(c.pointerId);
    t.current?.focus();
    e.begin?.();
    if (v) e.on(Ft(d));
  };
  const i = (c) => {
    const u = n.current;
    if (!u || u.id !== c.pointerId) return;
    const d = c.currentTarget.getBoundingClientRect();
    const v = e.vertical ? (u.y - c.clientY) / (d.height - 16) : (c.clientX - u.x) / (d.width - 12);
    u.x = c.clientX;
    u.y = c.clientY;
    u.at += v * (c.shiftKey ? 0.1 : 1);
    e.on(Ft(u.at));
  };
  const a = (c) => {
    if (n.current?.id !== c.pointerId) return;
    n.current = null;
    if (c.type === "pointercancel") e.cancel?.();
    else e.end?.();
  };
  const l = (c) => {
    if (c.key === "Escape" && n.current) {
      n.current = null;
      e.cancel?.();
      c.stopPropagation();
      return;
    }
    const u = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[c.key];
    let d = null;
    if (u) d = Ft(e.value + u * o * (c.shiftKey ? 10 : 1));
    if (c.key === "Home") d = 0;
    if (c.key === "End") d = 1;
    if (d === null || c.altKey || c.ctrlKey || c.metaKey) return;
    c.preventDefault();
    c.stopPropagation();
    e.on(d);
  };
  const p = (c) => {
    if (performance.now() - aa < 400 || c.ctrlKey) return;
    c.preventDefault();
    const u = Math.abs(c.deltaY) >= Math.abs(c.deltaX) ? c.deltaY : c.deltaX;
    if (u) e.on(Ft(e.value - Math.sign(u) * o * (c.shiftKey ? 0.2 : 1)));
  };
  return /* @__PURE__ */ s(
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
      style: { "--t": Ft(e.value) },
      onPointerDown: r,
      onPointerMove: i,
      onPointerUp: a,
      onPointerCancel: a,
      onMouseDown: (c) => c.preventDefault(),
      onTouchStart: (c) => c.cancelable && c.preventDefault(),
      onKeyDown: l,
      onWheel: p,
      onDblClick: () => e.reset?.(),
      onInput: (c) => {
        if (!n.current) e.on(Number(c.currentTarget.value));
        else c.currentTarget.value = String(e.value);
      }
    }
  );
}

// src/bar.tsx
function pr({ id: e, label: t, title: n, children: o }) {
  const r = (a) => {
    const l = document.getElementById(e);
    const p = a.getBoundingClientRect();
    l?.style.setProperty("left", `${Math.max(8, Math.min(p.left, innerWidth - 296))}px`);
    l?.style.setProperty("top", `${p.bottom + 4}px`);
  };
  const i = { popovertarget: e };
  return /* @__PURE__ */ s(Q, { children: [
    /* @__PURE__ */ s("button", { ...i, title: n, "aria-label": n, "aria-haspopup": "true", onPointerDown: (a) => r(a.currentTarget), onFocus: (a) => r(a.currentTarget), children: t }),
    /* @__PURE__ */ s("div", { id: e, popover: "auto", class: "menu", children: o })
  ] });
}
function yt({ id: e, label: t }) {
  const n = Zi(e);
  const o = Mn.find((r) => r.id === e);
  return /* @__PURE__ */ s(
    "button",
    {
      class: "item",
      "aria-disabled": n !== null,
      title: n ?? void 0,
      onClick: (r) => {
        r.currentTarget.closest("[popover]")?.hidePopover();
        ae(e);
      },
      children: [
        /* @__PURE__ */ s("span", { children: t ?? o?.label }),
        /* @__PURE__ */ s("kbd", { children: ea(e) })
      ]
    }
  );
}
function Xs() {
  const e = ta();
  return /* @__PURE__ */ s(pr, { id: "view-menu", label: /* @__PURE__ */ s(Q, { children: [
    "View ",
    /* @__PURE__ */ s(B, { name: "down" })
  ] }), title: "View", children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((t) => /* @__PURE__ */ s(yt, { id: t }, t)),
    /* @__PURE__ */ s("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((t) => /* @__PURE__ */ s(yt, { id: `preset-${t}` }, t)),
    /* @__PURE__ */ s("hr", {}),
    e.length > 0 && /* @__PURE__ */ s("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    e.map(({ name: t, camera: n }, o) => /* @__PURE__ */ s("button", { class: "item", onClick: () => O(n, t), children: /* @__PURE__ */ s("span", { children: t }) }, o)),
    e.length > 0 && /* @__PURE__ */ s("hr", {}),
    /* @__PURE__ */ s(yt, { id: "walking", label: Ye.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    /* @__PURE__ */ s(yt, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((t) => /* @__PURE__ */ s(yt, { id: `hands-${t}` }, t))
  ] });
}
var Ys = ["linear", "reinhard", "filmic"];
function Js() {
  const e = ct.value;
  return /* @__PURE__ */ s(pr, { id: "seeing-menu", label: /* @__PURE__ */ s(Q, { children: [
    "Picture ",
    /* @__PURE__ */ s(B, { name: "down" })
  ] }), title: "Tone and white", children: [
    /* @__PURE__ */ s("fieldset", { children: [
      /* @__PURE__ */ s("legend", { children: "Tone curve" }),
      /* @__PURE__ */ s("div", { class: "segments", children: Ys.map((t) => /* @__PURE__ */ s("button", { "aria-pressed": e.tone === t, onClick: () => Ie({ tone: t }), children: t }, t)) })
    ] }),
    /* @__PURE__ */ s("fieldset", { children: [
      /* @__PURE__ */ s("legend", { children: "White balance" }),
      /* @__PURE__ */ s("label", { class: "line", children: [
        /* @__PURE__ */ s("span", { children: "White" }),
        /* @__PURE__ */ s(fo, { label: "White", quantity: "kelvin", value: e.white.kelvin, step: 100, set: (t) => Ie({ white: { ...e.white, kelvin: t(e.white.kelvin) } }) })
      ] }),
      /* @__PURE__ */ s("label", { class: "line", children: [
        /* @__PURE__ */ s("span", { children: "Tint" }),
        /* @__PURE__ */ s(fo, { label: "Tint of white", quantity: "number", value: e.white.tint, step: 1, set: (t) => Ie({ white: { ...e.white, tint: t(e.white.tint) } }) })
      ] })
    ] }),
    /* @__PURE__ */ s("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((t) => /* @__PURE__ */ s(yt, { id: t }, t))
  ] });
}
function Qs() {
  return /* @__PURE__ */ s(pr, { id: "page-menu", label: /* @__PURE__ */ s(B, { name: "menu" }), title: "Page", children: [
    /* @__PURE__ */ s("label", { class: "line", children: [
      /* @__PURE__ */ s("span", { children: "House lights" }),
      /* @__PURE__ */ s(po, { label: "House lights", value: Ht.value, text: `${U(Ht.value * 100)} %`, on: (e) => Ht.value = Math.max(0.3, e) })
    ] }),
    /* @__PURE__ */ s("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => /* @__PURE__ */ s("button", { "aria-pressed": Xe.value === e, onClick: () => Xe.value = e, children: e }, e)) }),
    /* @__PURE__ */ s("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => /* @__PURE__ */ s(yt, { id: e }, e))
  ] });
}
var sa = {
  clean: "nothing changed",
  saved: "saved",
  waiting: "saving…",
  failed: "not saved"
};
function la() {
  const e = ct.value;
  const t = $e.value.undo;
  const n = $e.value.redo;
  const o = ut.value;
  const r = e.metered !== null && Math.abs(e.ev - e.metered) < 5e-3;
  return /* @__PURE__ */ s("header", { class: "bar", children: [
    /* @__PURE__ */ s(Qs, {}),
    /* @__PURE__ */ s("h1", { title: o.file || J.value?.file, children: [
      J.value?.name ?? "Lampyris",
      /* @__PURE__ */ s("i", { class: `dot ${o.state}`, role: "img", "aria-label": sa[o.state], title: `${sa[o.state]}${o.file ? `: ${o.file}` : ""}` })
    ] }),
    /* @__PURE__ */ s("span", { class: "group", children: [
      /* @__PURE__ */ s("button", { class: "icon", "aria-label": t ? `Undo: ${t}` : "Undo", title: t ? `Undo: ${t} (Ctrl+Z)` : "Nothing to undo", "aria-disabled": t === null, onClick: () => ae("undo"), children: /* @__PURE__ */ s(B, { name: "undo" }) }),
      /* @__PURE__ */ s("button", { class: "icon", "aria-label": n ? `Redo: ${n}` : "Redo", title: n ? `Redo: ${n} (Ctrl+Shift+Z)` : "Nothing to redo", "aria-disabled": n === null, onClick: () => ae("redo"), children: /* @__PURE__ */ s(B, { name: "redo" }) })
    ] }),
    /* @__PURE__ */ s(Xs, {}),
    /* @__PURE__ */ s("span", { class: "group wide", children: [
      /* @__PURE__ */ s("button", { "aria-pressed": false, onClick: () => ae("preset-plan"), title: "Plan (Shift+1)", children: "Plan" }),
      /* @__PURE__ */ s("button", { onClick: () => ae("inside"), title: "Inside (Shift+0)", children: "Inside" })
    ] }),
    /* @__PURE__ */ s("span", { class: "gap" }),
    /* @__PURE__ */ s(Js, {}),
    /* @__PURE__ */ s("button", { "aria-pressed": e.false_color !== null, onClick: sr, title: "False colour (B)", children: "False colour" }),
    /* @__PURE__ */ s("button", { "aria-pressed": ve.value === "wipe", "aria-disabled": no.value === null, onClick: () => ae("wipe"), title: "Wipe between before and now (C); hold \\ to see before", children: "Compare" }),
    /* @__PURE__ */ s("span", { class: "group exposure", role: "group", "aria-label": "Exposure", children: [
      /* @__PURE__ */ s("button", { class: "icon", "aria-label": "Darker", title: "Darker by ⅓ (,)", onClick: () => Sn(1), children: /* @__PURE__ */ s(B, { name: "minus" }) }),
      /* @__PURE__ */ s("label", { children: [
        /* @__PURE__ */ s("span", { "aria-hidden": "true", children: "EV" }),
        /* @__PURE__ */ s(fo, { label: "Exposure value", quantity: "ev", value: e.ev, step: 1 / 3, set: (i) => Ie({ ev: i(e.ev) }) })
      ] }),
      /* @__PURE__ */ s("button", { class: "icon", "aria-label": "Brighter", title: "Brighter by ⅓ (.)", onClick: () => Sn(-1), children: /* @__PURE__ */ s(B, { name: "plus" }) }),
      /* @__PURE__ */ s("button", { class: "icon", "aria-label": "Meter once", title: `${r ? "As metered" : "Meter once"} (/); it stays locked`, onClick: () => D({ do: "expose" }), children: /* @__PURE__ */ s(B, { name: r ? "lock" : "meter" }) })
    ] }),
    /* @__PURE__ */ s(
      "button",
      {
        class: "icon look-lock",
        "aria-pressed": ge.value,
        "aria-label": "Look-only lock",
        title: "Look-only lock: no finger changes anything",
        onClick: () => ge.value = !ge.value,
        children: /* @__PURE__ */ s(B, { name: ge.value ? "lock" : "unlock" })
      }
    ),
    me.value === "edit" && /* @__PURE__ */ s("button", { class: "wide", onClick: () => xe.value = "share", children: "Share" }),
    /* @__PURE__ */ s("button", { class: "icon", "aria-label": "All keys", title: "All keys (?)", onClick: () => xe.value = "help", children: /* @__PURE__ */ s(B, { name: "help" }) }),
    /* @__PURE__ */ s("button", { class: "icon", "aria-label": "Command palette", title: "Command palette (Ctrl+K)", onClick: () => xe.value = "palette", children: /* @__PURE__ */ s(B, { name: "search" }) }),
    /* @__PURE__ */ s(
      "button",
      {
        class: "icon narrow",
        "aria-label": et.value === "inspector" ? "Lamps" : "Inspector",
        title: et.value === "inspector" ? "Lamps" : "Inspector",
        onClick: () => et.value = et.value === "inspector" ? "lamps" : "inspector",
        children: /* @__PURE__ */ s(B, { name: et.value === "inspector" ? "lamps" : "sliders" })
      }
    )
  ] });
}

// src/lights.ts
var _t = g(null);
var dr = () => {
};
var ca = () => {
};
function mo(e, t, n) {
  mr();
  _t.value = { x: e, y: t, hit: n, lux: n.lux, lamps: [], done: false };
  ua(n);
  let o = true;
  let r = 0;
  ca = E(() => {
    for (const [, i] of S.all()) void sn(i);
    if (o) {
      o = false;
      return;
    }
    clearTimeout(r);
    r = window.setTimeout(() => {
      const i = oe(() => _t.value);
      if (i) ua(i.hit);
    }, 250);
  });
}
function ua(e) {
  dr();
  dr = he("light", { point: e.point, normal: e.normal }, (t) => {
    const n = _t.peek();
    if (!n) return;
    _t.value = {
      ...n,
      lux: t.lux ?? n.lux,
      lamps: t.lamps ?? n.lamps,
      done: t.done !== false
    };
  });
}
function mr() {
  dr();
  ca();
  _t.value = null;
}

// src/keys.ts
var Zs = g("W A S D");
var hr = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyA: [0, -1, 0],
  KeyD: [0, 1, 0],
  KeyQ: [0, 0, -1],
  KeyE: [0, 0, 1]
};
var el = 1.8;
var qt = /* @__PURE__ */ new Set();
var ho = false;
var vo = 1;
var vr = false;
var gr = 0;
function ga(e) {
  const t = Math.min(0.1, Math.max(0, (e - gr) / 1e3));
  gr = e;
  if (!qt.size) {
    vr = false;
    return;
  }
  let [n, o, r] = [0, 0, 0];
  for (const l of qt) {
    const [p, c, u] = hr[l];
    n += p;
    o += c;
    r += u;
  }
  const i = Math.max(1, Ve(..._n()) / 12);
  const a = el * t * vo * Math.min(i, 6);
  if (n || o || r) qi(n * a, o * a, r * a);
  requestAnimationFrame(ga);
}
function En(e) {
  qt.add(e);
  if (vr) return;
  vr = true;
  gr = performance.now();
  requestAnimationFrame(ga);
}
var tl = (e) => e instanceof HTMLElement && (e.isContentEditable || e.matches("input, textarea, select") && !e.matches("[type=range], [type=checkbox], [type=radio]"));
function fa() {
  const e = document.activeElement;
  return e === null || e === document.body || e.id === "view";
}
var nl = {
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
};
var pa = {
  b: "quantity",
  o: "park",
  i: "unsolo",
  l: "from-lamp",
  g: "grid",
  t: "aim-here"
};
var da = { Comma: "darker", Period: "brighter", Slash: "expose" };
var ma = {
  Digit1: "preset-plan",
  Digit2: "preset-ceiling",
  Digit3: "preset-north",
  Digit4: "preset-east",
  Digit5: "preset-south",
  Digit6: "preset-west",
  Digit0: "inside"
};
function ol(e) {
  const t = e.key.toLowerCase();
  if (t === "z") return e.shiftKey ? "redo" : "undo";
  if (t === "y") return "redo";
  if (t === "k") return "palette";
  if (t === "s") return e.shiftKey ? "picture" : "save";
  if (t === "d") return "duplicate";
  if (t === "a") return "all-lamps";
  if (t === "enter") return "look-store";
  return null;
}
function rl() {
  if (N.peek()) N.value = null;
  else if (_t.peek()) mr();
  else if (ve.peek()) ve.value = null;
  else if (K.peek()) pn();
  else if (document.activeElement?.id === "view") {
    const e = document.querySelector('.bar button, .bar [tabindex="0"]');
    e?.focus();
  }
}
function ha(e) {
  const [t, n] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
  if (!t && !n) return false;
  if (e.ctrlKey || te()?.height) Nt(-t * 24, n * 24, 3);
  else if (e.shiftKey) so(Kt(), -t * 0.05, n * 0.05);
  else ao(-t * 0.06, n * 0.06);
  return true;
}
function va(e) {
  const t = te();
  const n = gt();
  if (!t || !n) return;
  if (t.height) O(Gn(t, n, n.width / 2, n.height / 2, e));
  else O(zn(t, t.target, e, 0.3, true));
}
function il(e) {
  if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
  const t = e.ctrlKey || e.metaKey;
  if (e.key === "Escape") return rl();
  if (tl(e.target)) {
    if (t && e.key.toLowerCase() === "k") Ke(e, "palette");
    return;
  }
  if (t && !e.altKey) {
    if (fa() && ha(e)) return e.preventDefault();
    const i = ol(e);
    if (i) Ke(e, i);
    return;
  }
  if (e.altKey) {
    const i = /^Digit(\d)$/.exec(e.code)?.[1];
    if (e.key === "ArrowLeft") return Ke(e, "back");
    if (e.key === "ArrowRight") return Ke(e, "forth");
    if (i === "0") return Ke(e, "store-view");
    if (i) {
      e.preventDefault();
      const a = Ue.all()[Number(i) - 1];
      if (a) O(a[1], a[1].name ?? "view");
      return;
    }
    if (e.code === "KeyH") Ke(e, "unhide");
    if (!(e.code in hr)) return;
  }
  const n = fa();
  if (n && ha(e)) return e.preventDefault();
  if (n && e.code in hr) {
    vo = e.shiftKey ? 4 : e.altKey ? 0.25 : 1;
    En(e.code);
    return e.preventDefault();
  }
  if (n && (e.key === "+" || e.key === "=")) return va(0.85);
  if (n && (e.key === "-" || e.key === "_")) return va(1 / 0.85);
  if (!Hi.peek()) return;
  if (e.shiftKey && ma[e.code]) return Ke(e, ma[e.code]);
  if (ho && /^\d$/.test(e.key)) {
    e.preventDefault();
    ho = false;
    const i = an.ids.peek()[Number(e.key) - 1];
    if (i !== void 0) bt({ do: "look", id: i, what: "recall", seconds: Di.peek() });
    return;
  }
  ho = e.key.toLowerCase() === "j";
  if (ho) return q("Recall a look: now its digit.");
  if (!e.shiftKey && /^\d$/.test(e.key) && ee.peek().length) {
    e.preventDefault();
    Qi.value = e.key;
    return;
  }
  if (!e.shiftKey && da[e.code]) return Ke(e, da[e.code]);
  if (e.key === "\\") return void (e.repeat || Rt(true));
  const o = e.key.toLowerCase();
  if (o === "l" && !e.shiftKey) return void (e.repeat || ae("highlight"));
  if (o === "p" && e.shiftKey) return al();
  const r = e.shiftKey && pa[o] ? pa[o] : nl[o];
  if (r && !(e.target instanceof HTMLButtonElement && o === "enter")) Ke(e, r);
}
function al() {
  const [e, t] = we.peek();
  const n = Dt(e / 2, t / 2);
  if (n) he("point", n, (o) => o.hit && mo(e / 2, t / 2, o));
}
function Ke(e, t) {
  e.preventDefault();
  ae(t);
}
function sl(e) {
  qt.delete(e.code);
  if (e.key === "\\") Rt(false);
  if (e.key.toLowerCase() === "l") mn(false);
  if (e.key === "Shift") vo = 1;
}
function ba() {
  addEventListener("keydown", il);
  addEventListener("keyup", sl);
  addEventListener("blur", () => {
    qt.clear();
    mn(false);
    Rt(false);
  });
  const e = navigator.keyboard;
  void e?.getLayoutMap().then((t) => {
    Zs.value = ["KeyW", "KeyA", "KeyS", "KeyD"].map((n) => (t.get(n) ?? n.slice(3)).toUpperCase()).join(" ");
  }).catch(() => void 0);
}
function ya(e, t) {
  for (const n of ["KeyW", "KeyS", "KeyA", "KeyD"]) qt.delete(n);
  vo = Math.min(1, Math.hypot(e, t));
  if (e > 0.2) En("KeyW");
  if (e < -0.2) En("KeyS");
  if (t < -0.2) En("KeyA");
  if (t > 0.2) En("KeyD");
}

// src/load.tsx
var ka = g(null);
var _a = false;
function tt({ part: e }) {
  const t = ka.value?.[e];
  return t ? /* @__PURE__ */ s(t, {}) : null;
}
function wa() {
  E(() => {
    if (_a || !(G.value ?? K.value)) return;
    _a = true;
    const e = "./gizmo.js";
    setTimeout(() => void import(e).then((t) => ka.value = t), 0);
  });
}

// src/lamps.tsx
function xa() {
  return /* @__PURE__ */ s("section", { class: "panel lamps" });
}

// src/states.ts
var Pn = g(null);
var nt = g([]);
var Tn = g(null);
var yr = g(null);
var br = Y(() => Le.value?.stage ?? "loading");
var ll = Y(() => {
  const e = Le.value?.fps ?? 0;
  return br.value === "moving" && e > 6 && At.value < 0.4 * e && At.value < 5;
});
var Wt = Y(() => {
  switch (j.value) {
    case "entering":
      return "starting";
    case "open":
      break;
    default:
      return j.value;
  }
  if (!J.value || !G.value) return "loading";
  if (ut.value.state === "failed") return "unsaved";
  if (Pn.value !== null) return "broken";
  if (Tn.value !== null && !Z.value.you) return "control-lost";
  if (me.value === "watch" || !Z.value.you) return "watching";
  if (S.ids.value.length === 0) return "no-lamps";
  if (yi.value) return "all-off";
  if (ll.value) return "slow";
  if (br.value === "loading") return "first";
  return br.value;
});
Me("event", (e) => {
  switch (e.what) {
    case "reloaded": {
      Pn.value = null;
      nt.value = e.lost ?? [];
      const t = e.kept ?? 0;
      q(`The scene was read again: ${t} edits kept${nt.value.length ? `, ${nt.value.length} no longer find what they changed` : ""}.`);
      break;
    }
    case "broken":
      Pn.value = e.why ?? "The scene file cannot be read.";
      break;
    case "taken":
      Tn.value = e.by ?? Z.peek().name ?? "somebody else";
      break;
    case "loading":
      yr.value = e;
      break;
  }
});
Me("refused", (e) => q(e.why ?? "That could not be done.", "warn"));
E(() => {
  if (Z.value.you) Tn.value = null;
});

// src/probe.ts
var go = g(null);
function bo(e, t, n) {
  const o = Dt(e, t);
  if (!o) return n(null);
  he("point", o, (r) => n(r.hit ? r : null));
}
function Sa(e) {
  if (!e) return "";
  const t = [];
  const n = S.get(e.lamp)?.name;
  const o = le.get(e.thing)?.name;
  const r = rn.get(e.material)?.name;
  if (n) t.push(n);
  if (o && o !== n) t.push(o);
  if (r && r !== o) t.push(r);
  if (e.lux) t.push(`${Ot(e.lux[0])} ±${Ot(e.lux[1], false)}`);
  if (e.luminance) {
    const i = e.luminance[0] * (Je.value === "fc" ? 0.2919 : 1);
    t.push(`${Cn(i)} ${Je.value === "fc" ? "fL" : "cd/m²"}`);
  }
  return t.join(" · ");
}

// src/status.tsx
var Ma = Y(() => {
  void G.value;
  const e = [];
  for (const t of re.sent.slice(-24)) {
    if (t.what !== "set" && t.what !== "camera") continue;
    const n = re.frames.find((o) => o.seq >= t.seq && o.painted);
    if (n && n.painted > t.at) e.push(n.painted - (t.input || t.at));
  }
  e.sort((t, n) => t - n);
  return e.length ? e[e.length >> 1] : null;
});
function ul() {
  const e = Le.value;
  if (!e) return "starting";
  const t = e.error === null ? "" : ` ±${U(e.error * 100, e.error < 0.0995 ? 1 : 0)} %`;
  switch (e.stage) {
    case "loading":
      return "first look";
    case "moving":
      return `moving${t}`;
    case "refining":
      return `${t.trim() || "refining"}${e.good_in ? `, good in ${U(e.good_in, e.good_in < 3 ? 1 : 0)} s` : ""}`;
    case "good":
      return `good${t}`;
    case "done":
      return `finished${t}`;
  }
}
function Ca() {
  const e = Le.value;
  const t = G.value?.head;
  const n = Yn.value.filter((r) => r.batches < r.of && !r.held).length;
  const o = e?.stage === "refining" && e.good_in ? Math.max(0.02, 1 / (1 + e.good_in)) : e?.stage === "good" || e?.stage === "done" ? 1 : 0.02;
  return /* @__PURE__ */ s("footer", { class: "status", "aria-label": "Status", children: [
    /* @__PURE__ */ s("span", { class: `quality ${e?.stage ?? ""}`, children: [
      /* @__PURE__ */ s("i", { class: "thin", "aria-hidden": "true", children: /* @__PURE__ */ s("b", { style: { width: `${o * 100}%` } }) }),
      ul()
    ] }),
    /* @__PURE__ */ s("span", { children: [
      U(t?.batches ?? e?.batches ?? 0),
      " batches"
    ] }),
    /* @__PURE__ */ s("span", { children: j.value === "open" ? `${U(At.value)} fps` : "no line" }),
    Ma.value !== null && /* @__PURE__ */ s("span", { title: "From the hand to the paint, median", children: [
      U(Ma.value),
      " ms"
    ] }),
    t && /* @__PURE__ */ s("span", { children: [
      t.width,
      " × ",
      t.height
    ] }),
    /* @__PURE__ */ s("span", { class: "wide", children: [
      Yn.value.length,
      " layers",
      n ? `, ${n} tracing` : ""
    ] }),
    /* @__PURE__ */ s("span", { class: "probe", "aria-live": "off", children: Sa(go.value) }),
    /* @__PURE__ */ s("span", { class: "gap" }),
    /* @__PURE__ */ s("span", { children: Z.value.you ? "editing: you" : `editing: ${Z.value.name ?? "somebody else"}` }),
    /* @__PURE__ */ s("span", { class: "spoken", children: [
      Wo.value ?? "",
      " ",
      Wt.value
    ] })
  ] });
}

// src/strip.tsx
function Ea() {
  return /* @__PURE__ */ s("section", { class: "panel strip" });
}

// src/pointer.ts
var cl = 4;
var Pa = 35e-4;
var fl = 0.15;
function pl(e, t, n) {
  if (e === "maya" && n.alt) return ["orbit", "pan", "dolly"][t] ?? "none";
  if (e === "blender" && t === 1) return n.shift ? "pan" : n.ctrl ? "dolly" : "orbit";
  if (t === 1) return n.shift ? "pan" : "orbit";
  if (t === 2) return "look";
  if (t === 0) return n.alt ? "orbit" : n.space ? "pan" : n.shift || n.ctrl ? "none" : "look";
  return "none";
}
function Ta(e, t) {
  const n = /* @__PURE__ */ new Map();
  let o = Kt();
  let r = 3;
  let i = false;
  let a = 0;
  let l = 0;
  let p = 0;
  let c = null;
  const u = (m) => {
    const h = e.getBoundingClientRect();
    return [m.clientX - h.left, m.clientY - h.top];
  };
  const d = (m, h, P) => {
    const T = Dt(m, h);
    if (!T) return;
    he("point", T, (V) => {
      const L = V;
      if (L.hit) P?.(L);
    });
  };
  const v = (m) => {
    const h = gt();
    return h ? Math.max(0.2, F(A(m, h.eye), h.forward)) : r;
  };
  function f(m) {
    if (m.target.closest("[data-handle]")) return;
    e.focus({ preventScroll: true });
    const [h, P] = u(m);
    const T = m.pointerType === "touch";
    const V = { alt: m.altKey, shift: m.shiftKey, ctrl: m.ctrlKey || m.metaKey, space: i };
    let L = T ? "look" : pl(hn.peek(), m.button, V);
    if (L === "look" && te()?.height) L = "pan";
    if (N.peek() === "marquee" && m.button === 0) L = "none";
    n.set(m.pointerId, {
      id: m.pointerId,
      button: m.button,
      x: h,
      y: P,
      startX: h,
      startY: P,
      moved: false,
      motion: L,
      touch: T,
      shift: m.shiftKey,
      ctrl: V.ctrl
    });
    e.setPointerCapture(m.pointerId);
    clearTimeout(a);
    t.unhover();
    if (L === "orbit" || L === "pan" || L === "dolly") {
      o = Kt();
      r = v(o);
      d(h, P, (R) => {
        o = R.point;
        r = v(R.point);
      });
    }
    clearTimeout(l);
    if (T && n.size === 1) {
      l = window.setTimeout(() => {
        const R = n.get(m.pointerId);
        if (R && !R.moved && n.size === 1) {
          R.moved = true;
          R.motion = "none";
          t.menu(R.x, R.y);
        }
      }, 550);
    }
    if (n.size === 2) c = b();
    if (m.button === 1) m.preventDefault();
  }
  function b() {
    const [m, h] = [...n.values()];
    return { gap: Math.hypot(m.x - h.x, m.y - h.y), x: (m.x + h.x) / 2, y: (m.y + h.y) / 2 };
  }
  function _(m) {
    const h = n.get(m.pointerId);
    const [P, T] = u(m);
    if (!h) {
      if (m.pointerType === "touch" || m.buttons) return;
      t.unhover();
      clearTimeout(a);
      a = window.setTimeout(() => t.hover(P, T), 150);
      return;
    }
    const [V, L] = [P - h.x, T - h.y];
    if (!h.moved && Math.hypot(P - h.startX, T - h.startY) < cl) return;
    h.moved = true;
    h.x = P;
    h.y = T;
    if (n.size === 2 && c) {
      const R = b();
      Nt(R.x - c.x, R.y - c.y, r);
      if (R.gap > 8 && c.gap > 8) y(R.x, R.y, c.gap / R.gap, false);
      c = R;
      return;
    }
    if (N.peek() === "marquee" && h.button === 0) {
      t.marquee([h.startX, h.startY], [P, T], false);
      return;
    }
    switch (h.motion) {
      case "look": {
        const R = h.touch ? 1 : -1;
        ao(R * V * Pa, R * L * Pa);
        break;
      }
      case "orbit":
        so(o, -V * 6e-3, -L * 6e-3);
        break;
      case "pan":
        Nt(V, L, r);
        break;
      case "dolly":
        y(h.startX, h.startY, Math.exp(L * 6e-3), false);
        break;
      case "none":
        break;
    }
  }
  function x(m) {
    const h = n.get(m.pointerId);
    n.delete(m.pointerId);
    clearTimeout(l);
    if (n.size < 2) c = null;
    if (!h || m.type === "pointercancel") return;
    if (h.moved) {
      if (N.peek() === "marquee") t.marquee([h.startX, h.startY], [h.x, h.y], true);
      return;
    }
    if (h.touch) {
      const P = performance.now();
      const T = P - p < 320;
      p = P;
      if (T) return t.double();
      if (ge.peek()) return;
    }
    if (h.button === 2) t.menu(h.x, h.y);
    else if (h.button === 0) {
      const P = h.shift ? "add" : h.ctrl ? "toggle" : "only";
      t.click(h.x, h.y, P);
    }
  }
  let w = null;
  function y(m, h, P, T) {
    const V = te();
    const L = gt();
    if (!V || !L) return;
    if (V.height) return O(Gn(V, L, m, h, P));
    const R = performance.now();
    if (!w || R - w.time > 500 || Math.hypot(m - w.x, h - w.y) > 6) {
      w = { x: m, y: h, time: R, point: null };
      const wt = w;
      d(m, h, (xr) => {
        wt.point = xr.point;
        r = v(xr.point);
      });
    }
    w.time = R;
    const [Fa, qa] = [m - L.width / 2, L.height / 2 - h];
    const Wa = Math.min(r, Ve(V.eye, Kt()) + 1);
    const yo = (wt) => V.eye[wt] + (L.forward[wt] + L.side[wt] * Fa * L.pixel + L.up[wt] * qa * L.pixel) * Wa;
    const ja = w.point ?? [yo(0), yo(1), yo(2)];
    O(zn(V, ja, P, fl, T));
  }
  function I(m) {
    if (m.target.closest("[data-scroll]")) return;
    m.preventDefault();
    const h = m.deltaMode === 1 ? 18 : m.deltaMode === 2 ? 400 : 1;
    const [P, T] = [m.deltaX * h, m.deltaY * h];
    const [V, L] = u(m);
    if (hn.peek() === "trackpad" && !m.ctrlKey) return Nt(-P, -T, r);
    const R = (m.ctrlKey ? 6 : 1) * (Math.abs(T) > Math.abs(P) ? T : P);
    y(V, L, Math.exp(Math.max(-300, Math.min(300, R)) * 16e-4), m.shiftKey && !m.ctrlKey);
  }
  const $ = (m) => m.preventDefault();
  const Ne = () => {
    clearTimeout(a);
    t.unhover();
  };
  const Oe = (m) => {
    if (!m.target.closest("[data-handle]") && N.peek() === null) t.double();
  };
  const _e = (m) => {
    if (m.code === "Space") i = m.type === "keydown";
  };
  const de = new ResizeObserver(() => {
    const m = e.getBoundingClientRect();
    we.value = [Math.max(16, Math.round(m.width)), Math.max(16, Math.round(m.height))];
  });
  de.observe(e);
  e.addEventListener("pointerdown", f);
  e.addEventListener("pointermove", _);
  e.addEventListener("pointerup", x);
  e.addEventListener("pointercancel", x);
  e.addEventListener("pointerleave", Ne);
  e.addEventListener("wheel", I, { passive: false });
  e.addEventListener("contextmenu", $);
  e.addEventListener("dblclick", Oe);
  addEventListener("keydown", _e);
  addEventListener("keyup", _e);
  return () => {
    de.disconnect();
    removeEventListener("keydown", _e);
    removeEventListener("keyup", _e);
  };
}

// src/overlay.ts
var dl = "http://www.w3.org/2000/svg";
function ye(e, t = {}, n) {
  const o = document.createElementNS(dl, e);
  for (const [r, i] of Object.entries(t)) o.setAttribute(r, String(i));
  n?.append(o);
  return o;
}
var kr = class {
  view;
  fit;
  constructor(t) {
    this.view = t;
    this.fit = io(t.width, t.height);
  }
  at(t) {
    const [n, o, r] = Bn(this.view, t);
    if (r < 0.02 && !this.view.parallel) return null;
    return [this.fit.x + n * this.fit.scale, this.fit.y + o * this.fit.scale];
  }
  /** A line of the scene as a path, as much of it as lies before the eye. */
  line(t, n) {
    const [, , o] = Bn(this.view, t);
    const [, , r] = Bn(this.view, n);
    const i = 0.05;
    let [a, l] = [t, n];
    if (!this.view.parallel) {
      if (o < i && r < i) return "";
      const u = (i - o) / (r - o);
      const d = C(k(t, 1 - u), k(n, u));
      if (o < i) a = d;
      if (r < i) l = d;
    }
    const [p, c] = [this.at(a), this.at(l)];
    if (!p || !c) return "";
    return `M${p[0].toFixed(1)} ${p[1].toFixed(1)}L${c[0].toFixed(1)} ${c[1].toFixed(1)}`;
  }
};
function wr() {
  const e = G.value;
  void we.value;
  return e ? new kr(Zt(e.camera, e.head.width, e.head.height)) : null;
}
function Va() {
  const e = oe(wr);
  if (!e) return null;
  return S.all().flatMap(([t, n]) => {
    const o = $a(n);
    const r = o && e.at(o);
    return r ? [{ id: t, at: r }] : [];
  });
}
var $a = (e) => e.place?.position ?? (e.box ? st(e.box) : null);
var ml = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
function _r(e, t) {
  const n = Qt(t);
  return ml.map(([o, r]) => e.line(n[o], n[r])).join("");
}
var Vn = class {
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
    const n = /* @__PURE__ */ new Set();
    for (const { id: o, at: r, label: i, state: a } of t) {
      n.add(o);
      let l = this.marks.get(o);
      if (!l) {
        const p = ye("g", { "data-kind": this.kind, "data-id": o }, this.parent);
        this.shape(p);
        const c = ye("text", { x: 10, y: 4 }, p);
        l = { group: p, label: c };
        this.marks.set(o, l);
      }
      if (!r) {
        l.group.setAttribute("display", "none");
        continue;
      }
      l.group.removeAttribute("display");
      l.group.setAttribute("transform", `translate(${r[0].toFixed(1)} ${r[1].toFixed(1)})`);
      l.group.setAttribute("class", `mark ${this.kind} ${a}`);
      if (l.label.textContent !== i) l.label.textContent = i;
    }
    for (const [o, r] of this.marks) {
      if (n.has(o)) continue;
      r.group.remove();
      this.marks.delete(o);
    }
  }
};
function La(e) {
  const t = ye("path", { class: "aims" }, e);
  const n = ye("path", { class: "boxes" }, e);
  const o = ye("path", { class: "boxes hover" }, e);
  const r = ye("path", { class: "grid-lines" }, e);
  const i = new Vn(ye("g", {}, e), "lamp", (u) => ye("circle", { r: 4.5 }, u));
  const a = new Vn(ye("g", {}, e), "grid", () => void 0);
  const l = new Vn(ye("g", {}, e), "meter", (u) => {
    ye("circle", { r: 5.5 }, u);
    ye("path", { d: "M-9 0H9M0 -9V9" }, u);
  });
  const p = E(() => {
    const u = wr();
    if (!u) return;
    const d = K.value;
    const v = mt.value;
    let f = "";
    let b = "";
    const _ = S.all().map(([w, y]) => {
      const I = d?.kind === "lamp" ? d.ids.includes(w) : d?.kind === "group" && d.ids.includes(y.group ?? -1);
      const $ = v?.kind === "lamp" ? v.id === w : v?.kind === "group" && v.id === y.group;
      const Ne = $a(y);
      const Oe = y.place?.position;
      if (I && y.box) b += _r(u, y.box);
      if (Oe && y.place?.direction && (I || $)) {
        const m = y.place.aim ?? C(Oe, y.place.direction);
        f += u.line(Oe, m);
      }
      const _e = I || $ || gn.value && (y.own || y.place?.position);
      const de = `${I ? "selected" : ""} ${$ ? "under" : ""} ${sn(y) ? "" : "off"}`;
      return { id: w, at: Ne && _e ? u.at(Ne) : null, label: I || $ ? y.name : "", state: de };
    });
    i.draw(_);
    t.setAttribute("d", f);
    if (d?.kind === "thing") {
      for (const w of d.ids) {
        const y = le.get(w)?.box;
        if (y) b += _r(u, y);
      }
    }
    n.setAttribute("d", b);
    const x = v?.kind === "lamp" ? S.get(v.id)?.box : v?.kind === "thing" ? le.get(v.id)?.box : null;
    o.setAttribute("d", x ? _r(u, x) : "");
  });
  const c = E(() => {
    const u = wr();
    if (!u) return;
    const d = K.value;
    const v = (b, _) => d?.kind === b && d.ids.includes(_) ? "selected" : "";
    l.draw(Be.all().map(([b, _]) => ({
      id: b,
      at: u.at(_.point),
      label: _.lux ? Ot(_.lux[0]) : "…",
      state: v("meter", b)
    })));
    let f = "";
    a.draw(Tt.all().map(([b, _]) => {
      f += hl(u, _);
      const x = _.mean === null ? "…" : `${_.name} ${Ot(_.mean)}`;
      return { id: b, at: u.at(_.corner), label: x, state: v("grid", b) };
    }));
    r.setAttribute("d", f);
  });
  return () => {
    p();
    c();
    e.replaceChildren();
  };
}
function hl(e, t) {
  const n = (r, i) => C(t.corner, C(k(t.u, r), k(t.v, i)));
  let o = e.line(n(0, 0), n(1, 0)) + e.line(n(1, 0), n(1, 1)) + e.line(n(1, 1), n(0, 1)) + e.line(n(0, 1), n(0, 0));
  for (let r = 0; r < t.rows; r++) {
    for (let i = 0; i < t.columns; i++) {
      const a = e.at(n((i + 0.5) / t.columns, (r + 0.5) / t.rows));
      if (a) o += `M${(a[0] - 2).toFixed(1)} ${a[1].toFixed(1)}h4m-2 -2v4`;
    }
  }
  return o;
}

// src/banner.tsx
function fe({ tone: e, children: t }) {
  return /* @__PURE__ */ s("div", { class: `banner ${e}`, role: e === "warn" ? "alert" : "status", children: t });
}
var Aa = () => `lampyris view ${J.peek()?.file ?? "SCENE"} --port ${location.port || 80}`;
function vl() {
  const e = S.all().filter(([, n]) => !n.on || n.level === 0 || n.parked);
  const t = ke.all().filter(([, n]) => !n.on || n.level === 0);
  ue("All lamps on", {
    lamps: Object.fromEntries(e.map(([n, o]) => [n, { on: true, parked: false, ...o.level === 0 ? { level: 1 } : {} }])),
    groups: Object.fromEntries(t.map(([n, o]) => [n, { on: true, ...o.level === 0 ? { level: 1 } : {} }]))
  });
}
function gl() {
  bt({ do: "add", lamp: { name: "Sky", kind: "sky", on: true, level: 1, flux: 1e4, color: { mode: "kelvin", kelvin: 6500, tint: 0, rgb: [1, 1, 1], xy: [0.3127, 0.329] }, place: null } });
}
function bl() {
  switch (Wt.value) {
    case "starting":
      return /* @__PURE__ */ s(fe, { tone: "calm", children: "Entering…" });
    case "loading": {
      const e = yr.value;
      return /* @__PURE__ */ s(fe, { tone: "calm", children: [
        "Reading ",
        e?.file ?? J.value?.file ?? "the scene",
        "…",
        e?.bytes ? ` ${U(e.bytes / 1e6, 1)} MB` : "",
        e?.progress != null && /* @__PURE__ */ s("progress", { value: e.progress, max: 1, "aria-label": "Reading" })
      ] });
    }
    case "lost":
      return /* @__PURE__ */ s(fe, { tone: "warn", children: [
        "Connection lost, trying again",
        cn.value ? ` (${cn.value} s)` : "…",
        ". Until then nothing can be changed."
      ] });
    case "ended":
      return /* @__PURE__ */ s(fe, { tone: "warn", children: [
        "The program has ended. Start it again with ",
        /* @__PURE__ */ s("code", { children: Aa() }),
        /* @__PURE__ */ s("button", { onClick: () => void ur(Aa()), children: "Copy" }),
        " and this page comes back by itself."
      ] });
    case "denied":
      return /* @__PURE__ */ s(fe, { tone: "warn", children: "This link is not valid (any more). Open the one that the program has printed, or ask for a new one." });
    case "renewed":
      return /* @__PURE__ */ s(fe, { tone: "warn", children: [
        "New version. ",
        /* @__PURE__ */ s("button", { onClick: () => location.reload(), children: "Reload" })
      ] });
    case "unsaved":
      return /* @__PURE__ */ s(fe, { tone: "warn", children: [
        "Edits are not being saved: ",
        ut.value.why ?? "unknown reason",
        ".",
        /* @__PURE__ */ s("button", { onClick: () => xe.value = "save", children: "Save elsewhere" })
      ] });
    case "broken":
      return /* @__PURE__ */ s(fe, { tone: "warn", children: [
        Pn.value,
        " Still showing what was read before."
      ] });
    case "control-lost":
      return /* @__PURE__ */ s(fe, { tone: "warn", children: [
        "Control moved to ",
        /* @__PURE__ */ s("em", { children: Tn.value }),
        ". ",
        /* @__PURE__ */ s("button", { onClick: () => D({ do: "edit", what: "take" }), children: "Take it back" })
      ] });
    case "watching":
      return /* @__PURE__ */ s(fe, { tone: "calm", children: [
        "You are watching",
        Z.value.name ? /* @__PURE__ */ s(Q, { children: [
          "; ",
          /* @__PURE__ */ s("em", { children: Z.value.name }),
          " edits"
        ] }) : "",
        ".",
        /* @__PURE__ */ s("button", { onClick: () => D({ do: "edit", what: "take" }), children: "Ask for control" })
      ] });
    case "no-lamps":
      return /* @__PURE__ */ s(fe, { tone: "calm", children: [
        "This scene has no light. Add: ",
        /* @__PURE__ */ s("button", { onClick: gl, children: "sky" }),
        /* @__PURE__ */ s(
          "button",
          {
            onClick: () => {
              wn.value = "disc";
              De("add");
            },
            children: "ceiling lamp"
          }
        ),
        /* @__PURE__ */ s("button", { disabled: true, title: "Photometric files come with a later version", children: "IES file" })
      ] });
    case "all-off":
      return /* @__PURE__ */ s(fe, { tone: "warn", children: [
        "All lamps are off.",
        $e.value.undo && /* @__PURE__ */ s("button", { onClick: () => Mn.find((e) => e.id === "undo")?.run(), children: "Undo" }),
        /* @__PURE__ */ s("button", { onClick: vl, children: "Turn on" })
      ] });
    case "slow":
      return /* @__PURE__ */ s(fe, { tone: "calm", children: [
        "Slow connection.",
        /* @__PURE__ */ s("button", { "aria-pressed": Pe.value, onClick: () => Pe.value = true, children: "Sharper" }),
        /* @__PURE__ */ s("button", { "aria-pressed": !Pe.value, onClick: () => Pe.value = false, children: "Faster" })
      ] });
    default:
      return null;
  }
}
function Ia() {
  const e = lt.value;
  return /* @__PURE__ */ s("div", { class: "banners", "data-scroll": true, children: [
    bl(),
    nt.value.length > 0 && /* @__PURE__ */ s(fe, { tone: "calm", children: [
      /* @__PURE__ */ s("details", { children: [
        /* @__PURE__ */ s("summary", { children: [
          nt.value.length,
          " edits no longer find what they changed"
        ] }),
        /* @__PURE__ */ s("ul", { children: nt.value.map((t) => /* @__PURE__ */ s("li", { children: t }, t)) })
      ] }),
      /* @__PURE__ */ s("button", { onClick: () => nt.value = [], children: "Good" })
    ] }),
    e.length > 0 && /* @__PURE__ */ s("div", { class: "banner badge", role: "status", children: [
      "Solo: ",
      e.length === 1 ? S.get(e[0])?.name ?? "one lamp" : `${e.length} lamps`,
      /* @__PURE__ */ s("button", { onClick: ro, children: "End solo" })
    ] }),
    /* @__PURE__ */ s("div", { class: "notes", role: "status", "aria-live": "polite", children: pt.value.map((t) => /* @__PURE__ */ s("div", { class: `banner ${t.tone === "warn" ? "warn" : "calm"}`, children: [
      t.text,
      /* @__PURE__ */ s("button", { class: "icon", "aria-label": "Close", onClick: () => zo(t.id), children: /* @__PURE__ */ s(B, { name: "close" }) })
    ] }, t.id)) })
  ] });
}

// src/views.tsx
function Ra() {
  const e = Ue.all();
  return /* @__PURE__ */ s("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": true, children: [
    /* @__PURE__ */ s("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => ae("home"), children: /* @__PURE__ */ s(B, { name: "home" }) }),
    /* @__PURE__ */ s("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => ae("frame"), children: /* @__PURE__ */ s(B, { name: "frame" }) }),
    /* @__PURE__ */ s("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => ae("back"), children: /* @__PURE__ */ s(B, { name: "back" }) }),
    /* @__PURE__ */ s("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => ae("forth"), children: /* @__PURE__ */ s(B, { name: "forth" }) }),
    /* @__PURE__ */ s("span", { class: "divide" }),
    e.map(([t, n], o) => /* @__PURE__ */ s(
      "button",
      {
        class: "saved-view",
        "aria-pressed": vt.value === n.name,
        title: `${n.name ?? "View"} (Alt+${o + 1}); double click to rename, Delete to remove`,
        onClick: () => O(n, n.name ?? "view"),
        onDblClick: () => {
          const r = prompt("Name of the view", n.name ?? "");
          if (r) ue(`Rename the view ${r}`, { views: { [t]: { name: r } } });
        },
        onKeyDown: (r) => {
          if (r.key !== "Delete") return;
          r.stopPropagation();
          ue(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } });
        },
        children: [
          /* @__PURE__ */ s("small", { children: o + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    /* @__PURE__ */ s("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: lr, children: /* @__PURE__ */ s(B, { name: "plus" }) })
  ] });
}

// src/walkpad.tsx
function Ha() {
  const e = ne(null);
  const t = (n) => {
    const o = n.currentTarget;
    n.stopPropagation();
    if (n.type === "pointerdown") o.setPointerCapture(n.pointerId);
    const r = n.type === "pointerup" || n.type === "pointercancel";
    if (!r && !o.hasPointerCapture(n.pointerId)) return;
    const i = o.getBoundingClientRect();
    const a = (c) => Math.max(-1, Math.min(1, c));
    const l = r ? 0 : a((n.clientX - i.left) / (i.width / 2) - 1);
    const p = r ? 0 : a(1 - (n.clientY - i.top) / (i.height / 2));
    e.current?.style.setProperty("transform", `translate(${l * 28}px, ${-p * 28}px)`);
    ya(p, l);
  };
  return /* @__PURE__ */ s("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: /* @__PURE__ */ s("span", { ref: e }) });
}

// src/view.tsx
var Ka = g(null);
function yl(e, t) {
  const n = Va();
  if (!n) return [];
  const [o, r] = [Math.min(e[0], t[0]), Math.max(e[0], t[0])];
  const [i, a] = [Math.min(e[1], t[1]), Math.max(e[1], t[1])];
  return n.filter(({ at: l }) => l[0] >= o && l[0] <= r && l[1] >= i && l[1] <= a).map(({ id: l }) => l);
}
var _l = {
  click(e, t, n) {
    const o = Da(e, t);
    if (N.peek() === null && o) return ht(o.kind, o.id, n);
    bo(e, t, (r) => {
      if (r) Re.value = { point: r.point, normal: r.normal };
      if (N.peek() !== null) return Gi(r);
      Ai(r, n);
    });
  },
  menu(e, t) {
    bo(e, t, (n) => {
      if (n) mo(e, t, n);
    });
  },
  double() {
    lo();
  },
  hover(e, t) {
    const n = Da(e, t);
    if (n?.kind === "lamp") mt.value = { kind: "lamp", id: n.id };
    bo(e, t, (o) => {
      go.value = o;
      if (o) Re.value = { point: o.point, normal: o.normal };
      if (o?.lamp != null) mt.value = { kind: "lamp", id: o.lamp };
    });
  },
  unhover() {
    if (mt.peek()) mt.value = null;
  },
  marquee(e, t, n) {
    Ka.value = n ? null : { from: e, to: t };
    if (!n) return;
    const o = yl(e, t);
    K.value = o.length ? { kind: "lamp", ids: o } : null;
    N.value = null;
  }
};
function Da(e, t) {
  const n = document.getElementById("overlay");
  let o = null;
  let r = 11;
  for (const i of n?.querySelectorAll(".mark:not([display])") ?? []) {
    const a = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(i.getAttribute("transform") ?? "");
    if (!a) continue;
    const l = Math.hypot(Number(a[1]) - e, Number(a[2]) - t);
    if (l < r) {
      r = l;
      o = { kind: i.dataset.kind, id: Number(i.dataset.id) };
    }
  }
  return o;
}
var kl = {
  aim: "Click what shall be lit. Esc to leave.",
  meter: "Click where the meter shall lie. Esc to leave.",
  grid: "Click two opposite corners of the area. Esc to leave.",
  add: "Click where the lamp shall hang. Esc to leave.",
  marquee: "Drag around the lamps to select. Esc to leave."
};
function Na() {
  const e = ne(null);
  const t = ne(null);
  const n = ne(null);
  it(() => {
    Bo(t.current);
    const o = La(n.current);
    const r = Ta(e.current, _l);
    return () => {
      Bo(null);
      o();
      r();
    };
  }, []);
  Ho(() => {
    const o = G.value;
    t.current?.setAttribute("data-kind", o?.head.kind ?? "none");
  });
  return /* @__PURE__ */ s("main", { class: "view", "aria-label": "View", children: [
    /* @__PURE__ */ s(
      "div",
      {
        class: N.value ? "stage tooled" : "stage",
        id: "view",
        ref: e,
        tabIndex: 0,
        role: "application",
        "aria-label": `View of ${J.value?.name ?? "the scene"}${vt.value ? `, ${vt.value}` : ""}`,
        "aria-describedby": "view-keys",
        "data-tool": N.value ?? "",
        children: [
          /* @__PURE__ */ s("canvas", { ref: t, width: 640, height: 480, "aria-hidden": "true" }),
          /* @__PURE__ */ s("svg", { id: "overlay", ref: n, "aria-hidden": "true" }),
          /* @__PURE__ */ s(tt, { part: "Gizmo" }),
          /* @__PURE__ */ s(tt, { part: "Compare" }),
          /* @__PURE__ */ s(wl, {})
        ]
      }
    ),
    /* @__PURE__ */ s("p", { id: "view-keys", class: "spoken", children: "Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection, Escape leaves the view." }),
    N.value && /* @__PURE__ */ s("p", { class: "hint", role: "status", children: kl[N.value] }),
    /* @__PURE__ */ s(Ia, {}),
    /* @__PURE__ */ s(tt, { part: "Legend" }),
    /* @__PURE__ */ s(xl, {}),
    /* @__PURE__ */ s(Ra, {}),
    /* @__PURE__ */ s(Ha, {}),
    /* @__PURE__ */ s(tt, { part: "What" })
  ] });
}
function wl() {
  const e = Ka.value;
  if (!e) return null;
  const { from: t, to: n } = e;
  return /* @__PURE__ */ s("svg", { class: "rubber", "aria-hidden": "true", children: /* @__PURE__ */ s(
    "rect",
    {
      x: Math.min(t[0], n[0]),
      y: Math.min(t[1], n[1]),
      width: Math.abs(n[0] - t[0]),
      height: Math.abs(n[1] - t[1])
    }
  ) });
}
function xl() {
  const e = Ui.value;
  if (!e) return null;
  return /* @__PURE__ */ s("label", { class: "cut", "data-scroll": true, children: [
    /* @__PURE__ */ s("span", { children: "Cut" }),
    /* @__PURE__ */ s(
      po,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: `${U(e.value, 2)} metres`,
        on: (t) => Bi(t * e.most)
      }
    ),
    /* @__PURE__ */ s("output", { children: [
      U(e.value, 2),
      " m"
    ] })
  ] });
}

// src/main.tsx
function Sl() {
  return /* @__PURE__ */ s(Q, { children: [
    /* @__PURE__ */ s(la, {}),
    /* @__PURE__ */ s(xa, {}),
    /* @__PURE__ */ s(Na, {}),
    /* @__PURE__ */ s("section", { class: "panel inspector", "aria-label": "Inspector", children: /* @__PURE__ */ s(tt, { part: "Inspector" }) }),
    /* @__PURE__ */ s(Ea, {}),
    /* @__PURE__ */ s(Ca, {}),
    /* @__PURE__ */ s(tt, { part: "Sheets" })
  ] });
}
var kt = document.getElementById("desk");
kt.replaceChildren();
Hr(/* @__PURE__ */ s(Sl, {}), kt);
E(() => {
  kt.dataset.state = Wt.value;
  kt.dataset.line = j.value;
  kt.dataset.pen = me.value === "edit" && Z.value.you && !ge.value ? "yes" : "no";
});
E(() => {
  kt.dataset.panels = vn.value ? "yes" : "no";
  kt.dataset.drawer = et.value ?? "none";
});
E(() => {
  document.documentElement.dataset.theme = Xe.value;
  document.documentElement.style.setProperty("--house", String(Ht.value));
});
E(() => {
  if (J.value) document.title = `${J.value.name} – Lampyris`;
});
var Oa = 0;
E(() => {
  const [e, t] = we.value;
  const n = Pe.value ? Math.min(devicePixelRatio, 2) : 1;
  if (j.value !== "open") return;
  clearTimeout(Oa);
  Oa = window.setTimeout(() => D({ do: "size", width: Math.round(e * n), height: Math.round(t * n) }), 60);
});
wa();
ba();
void Si();
export {
  Ns as DEFAULT_FALSE,
  tn as Entry,
  fo as Field,
  Q as Fragment,
  dt as Gesture,
  B as Icon,
  ci as PRESETS,
  po as Range,
  Se as Slice,
  Et as across,
  ae as act,
  Mn as actions,
  C as add,
  As as addGrid,
  rr as addMeter,
  wn as adding,
  nr as aim,
  Gi as applyTool,
  he as ask,
  Ni as back,
  no as before,
  _n as bounds,
  Pn as broken,
  be as camera,
  Je as candles,
  Kt as centre,
  ee as chosenLamps,
  so as circle,
  ro as clearSolo,
  mr as closeWhat,
  bt as command,
  Rt as compareHeld,
  ve as comparing,
  ms as compass,
  Y as computed,
  Si as connect,
  Xi as copyAlong,
  ur as copyText,
  Qt as corners,
  pe as cross,
  Ui as cut,
  yi as dark,
  pn as deselect,
  U as digits,
  ct as display,
  Ve as distance,
  zn as dolly,
  F as dot,
  Bo as drawOn,
  et as drawer,
  ar as each,
  ue as edit,
  Z as editor,
  E as effect,
  Pi as endStroke,
  Sn as exposeBy,
  Di as fade,
  Pe as fine,
  io as fitted,
  ai as fly,
  Ae as followed,
  ia as format,
  Oi as forth,
  ui as frame,
  lo as frameSelection,
  xn as free,
  O as go,
  uo as goHome,
  ji as goInside,
  Wi as goPreset,
  Tt as grids,
  ke as groups,
  Go as handles,
  hn as hands,
  Is as hang,
  Me as hear,
  te as here,
  mn as highlight,
  $e as history,
  Ht as houseLights,
  mt as hovered,
  s as jsx,
  s as jsxs,
  No as keep,
  Ms as keepBefore,
  ea as keysOf,
  gn as lampMarks,
  S as lamps,
  Yn as layers,
  We as length,
  j as line,
  Yo as listing,
  yr as loading,
  ri as look,
  ge as lookOnly,
  an as looks,
  nt as lostEdits,
  Ot as luxText,
  Su as maintenance,
  rn as materials,
  Wo as me,
  on as merge,
  Be as meters,
  Fl as metres,
  st as middle,
  ds as mix,
  je as moved,
  Cs as nameOf,
  ta as namedViews,
  W as normal,
  pt as notes,
  qu as nudge,
  Vi as onBegin,
  mo as openWhat,
  si as orbit,
  sn as output,
  li as pan,
  vn as panels,
  ra as parse,
  Bs as percent,
  ki as picturesTo,
  Zt as pinhole,
  Rs as placed,
  Hs as positions,
  fi as preset,
  Bn as project,
  At as rate,
  Ol as ray,
  ys as readHead,
  gi as receivePatch,
  vi as receiveState,
  Vt as releaseUpTo,
  Yi as removeLamps,
  cn as retryIn,
  me as role,
  en as same,
  ut as saved,
  q as say,
  k as scale,
  J as scene,
  ht as select,
  Ai as selectHit,
  or as selectNext,
  gu as selectRange,
  K as selection,
  D as send,
  Bi as setCut,
  Qn as settle,
  xe as sheet,
  Ie as show,
  G as shown,
  g as signal,
  Hi as singleKeys,
  Nt as slide,
  ll as slow,
  Ei as snapshot,
  lt as solo,
  Es as soloLamps,
  Ii as soloSelection,
  Ls as spacing,
  Re as spot,
  br as stage,
  De as startTool,
  Wt as state,
  Le as status,
  to as step,
  Xo as stepSelection,
  Os as storeLook,
  lr as storeView,
  qi as stride,
  au as stroke,
  A as sub,
  Tn as taken,
  Xe as theme,
  le as things,
  Cn as three,
  Ge as titleOf,
  Dt as toFrame,
  sr as toggleFalse,
  Li as toggleWipe,
  N as tool,
  Jo as travel,
  jn as turn,
  ao as turnHead,
  zo as unsay,
  oe as untracked,
  He as up,
  ss as useComputed,
  it as useEffect,
  ne as useRef,
  Jt as useSignal,
  Ho as useSignalEffect,
  Fs as viewFromLamp,
  vt as viewName,
  gt as viewPinhole,
  we as viewSize,
  Ue as views,
  ii as walk,
  Ye as walking,
  Qi as wantLevel,
  _t as what,
  ie as whyNot,
  Zi as whyNotTo,
  du as wipeAt,
  Gn as zoom
};
