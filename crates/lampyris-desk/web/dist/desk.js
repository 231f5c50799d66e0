// node_modules/preact/dist/preact.mjs
var $;
var zr;
var No;
var nt;
var Ko;
var qn;
var Gr;
var Fn;
var Xr;
var qo;
var Fo;
var Ms;
var on = /* @__PURE__ */ Symbol.for("pv");
var Un = {};
var jn = [];
var Cs = /^m(i|n|o|s|text|space)$/;
var Uo = Array.isArray;
var jo = jn.slice;
var _t = Object.assign;
function yt(e) {
  e && e.parentNode && e.remove();
}
function Yr(e, t, n) {
  var o, r, i, s = {}, l = arguments.length;
  for (i in t) "key" == i ? o = t[i] : "ref" == i && "function" != typeof e ? r = t[i] : s[i] = t[i];
  return l > 2 && (s.children = l > 3 ? jo.call(arguments, 2) : n), nn(e, s, o, r, null);
}
function nn(e, t, n, o, r) {
  var i = { type: e, props: t, key: n, ref: o, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: on, __v: r || ++zr, __i: -1, __u: 0 };
  return !r && $.vnode && $.vnode(i), i;
}
function X(e) {
  return e.children;
}
function Rt(e, t) {
  this.props = e, this.context = t, this.__g = 0;
}
function ot(e, t) {
  if (null == t) return e.__ && ot(e.__, e.__i + 1);
  for (var n; t < e.__k.length; t++) if ((n = e.__k[t]) && n.__e) return n.__e;
  return "function" != typeof e.type || e.props.__P ? null : ot(e);
}
function $s(e) {
  var t, n = e.__v, o = n.__e, r = [], i = [], s = e.__P;
  s && ((t = _t({ constructor: on }, n)).__v = n.__v + 1, $.vnode && $.vnode(t), Wo(s, t, n, e.__n, s.namespaceURI, 32 & n.__u ? [o] : null, r, o || ot(n), 32 & n.__u, i), t.__v = n.__v, t.__.__k[t.__i] = t, ni(r, t, i), n.__ = n.__e = null, t.__e != o && Jr(t));
}
function Jr(e) {
  if ((e = e.__) && e.__c && !e.props.__P) return e.__e = null, e.__k.some(function(t) {
    return t && (e.__e = t.__e);
  }), Jr(e);
}
function Wr(e) {
  (8 & e.__g || (e.__g |= 8, nt.push(e), qn++)) && Ko == $.debounceRendering || ((Ko = $.debounceRendering) || queueMicrotask)(Qr);
}
function Qr() {
  try {
    for (var e, t = 1; nt.length; ) nt.length > t && nt.sort(Gr), e = nt.shift(), t = nt.length, 8 & e.__g && $s(e);
  } finally {
    (qn = nt.length) && (Ko || queueMicrotask)(Qr);
  }
}
function Zr(e, t, n, o, r, i, s, l, d, u, c) {
  var f, m, p, _, w, S, k = o.__k || jn, b = t.length;
  for (d = Es(n, t, k, d, b), f = 0; f < b; f++) null != (p = n.__k[f]) && (m = ~p.__i && k[p.__i] || Un, p.__i = f, S = Wo(e, p, m, r, i, s, l, d, u, c), _ = p.__e, (m.ref != p.ref || 8 & m.__u) && (m.ref && Bo(m.ref, null, p, m), p.ref && c.push(p.ref, p.__c || _, p)), w = w || _, 4 & p.__u ? (d = ei(p, d, e, !m.__v), m.__e && (m.__e = null)) : "function" == typeof p.type && void 0 !== S ? d = S : _ && (d = _.nextSibling), p.__u &= -21);
  return n.__e = w, d;
}
function Es(e, t, n, o, r) {
  var i, s, l, d, u, c, f, m, p, _ = n.length, w = _, S = 0, k = 0, b = e.__k = Array(r);
  for (i = 0; i < r; i++) null != (s = t[i]) && "boolean" != typeof s && "function" != typeof s ? ("object" != typeof s || s.constructor === String ? s = b[i] = nn(null, s) : Uo(s) ? s = b[i] = nn(X, { children: s }) : s.constructor === on && s.__b ? s = b[i] = nn(s.type, s.props, s.key, s.ref, s.__v) : b[i] = s, d = i + S, s.__ = e, s.__b = e.__b + 1, l = null, ~(u = s.__i = Ts(s, n, d, w)) && (w--, (l = n[u]) && (l.__u |= 2)), l && l.__v ? (s.__u |= 16, u == d - 1 ? S-- : u == d + 1 ? S++ : u != d && (u > d ? S-- : S++, k = 1)) : (~u || (r > _ ? S-- : r < _ && S++), "function" != typeof s.type && (s.__u |= 4))) : b[i] = null;
  if (k) {
    for (c = [], f = [], i = 0; i < r; i++) if ((s = b[i]) && 16 & s.__u) {
      for (S = 0, m = c.length; S < m; ) c[p = S + m >> 1] < s.__i ? S = p + 1 : m = p;
      c[S] = s.__i, f[i] = S + 1;
    }
    for (S = c.length; i--; ) f[i] && (f[i] == S ? S-- : b[i].__u |= 4);
  }
  if (w) for (i = 0; i < _; i++) !(l = n[i]) || 2 & l.__u || (l.__e == o && (o = ot(l)), zo(l, l));
  return o;
}
function ei(e, t, n, o) {
  var r, i, s, l;
  if ("function" == typeof e.type) {
    if (e.props.__P) return t;
    if (r = e.__k) for (i = 0; i < r.length; i++) r[i] && (r[i].__ = e, t = ei(r[i], t, n, false));
    return t;
  }
  for (t && !t.parentNode && (t = ot(e)) && !t.parentNode && (t = null), s = e.__e, l = t; l && 8 == l.nodeType; ) l = l.nextSibling;
  for (s != l && (!o && n.moveBefore && s.parentNode ? n.moveBefore(s, t) : n.insertBefore(s, t || null)), t = s; (t = t && t.nextSibling) && 8 == t.nodeType && !t.data.startsWith("$s"); ) ;
  return t;
}
function Ts(e, t, n, o) {
  var r, i = e.key, s = e.type, l = t[n], d = l && !(2 & l.__u);
  if (null === l && null == i || d && i == l.key && s == l.type) return n;
  if (o > (d ? 1 : 0)) {
    for (r = n - 1; r >= 0; r--) if ((l = t[r]) && !(2 & l.__u) && i == l.key && s == l.type) return r;
    for (r = n + 1; r < t.length; r++) if ((l = t[r]) && !(2 & l.__u) && i == l.key && s == l.type) return r;
  }
  return -1;
}
function Br(e, t, n) {
  null == n && (n = ""), "-" == t[0] ? e.setProperty(t, n) : e[t] = n;
}
function Kn(e, t, n, o, r) {
  var i, s;
  if ("style" == t) if ("string" == typeof n) e.style.cssText = n;
  else {
    if ("string" == typeof o && (e.style.cssText = o = ""), o) for (t in o) n && t in n || Br(e.style, t);
    if (n) for (t in n) o && n[t] == o[t] || Br(e.style, t, n[t]);
  }
  else if ("o" == t[0] && "n" == t[1]) "function" != typeof n && (n = null), "function" != typeof o && (o = null), (e.__e || (e.__e = {}))[t] = n, n && o || (s = Fo[t] || (Fo[t] = Ps(t)), (e.__a || (e.__a = {}))[t] = qo, i = t != (t = t.replace(Xr, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), n ? e.addEventListener(t, s, i) : e.removeEventListener(t, s, i));
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
function Ps(e) {
  return function(t) {
    var n = this.__e;
    if (n) {
      if (n = n[e], null == t[Fn]) t[Fn] = qo++;
      else if (t[Fn] < this.__a[e]) return;
      return n($.event ? $.event(t) : t);
    }
  };
}
function Wo(e, t, n, o, r, i, s, l, d, u) {
  var c, f, m, p, _, w, S, k, b, D, I, et, tt, Ce, ye, h, g, P, L = t.type;
  if (t.constructor !== on) return null;
  128 & n.__u && (d = 32 & n.__u, c = n.__c.__z) && (t.__u |= d, f = i = [], 8 == c.nodeType ? l = Nn(c, i) : i.push(c), l = i[0] || l), (c = $.__b) && c(t);
  e: if ("function" == typeof L) {
    m = s.length;
    try {
      if (k = t.props, b = (c = L.prototype) && c.render, D = (c = L.contextType) && o[c.__c], I = c ? D ? D.props.value : c.__ : o, (p = n.__c) ? (t.__c = p, 2 & p.__g && (p.__g |= 1)) : (b ? t.__c = p = new L(k, I) : (t.__c = p = new Rt(k, I), p.constructor = L, p.render = Vs), D && D.sub(p), p.state || (p.state = {}), p.__n = o, p.__g |= 8, p.__h = [], p.__k = []), b && (p.__s || (p.__s = p.state), L.getDerivedStateFromProps && (p.__s == p.state && (p.__s = _t({}, p.__s)), _t(p.__s, L.getDerivedStateFromProps(k, p.__s)))), _ = p.props, w = p.state, p.__v = t, n.__c) {
        if (k !== _ && b && !L.getDerivedStateFromProps && p.componentWillReceiveProps && p.componentWillReceiveProps(k, I), t.__v == n.__v && !(8 & p.__g) || !(4 & p.__g) && p.shouldComponentUpdate && false === p.shouldComponentUpdate(k, p.__s, I)) {
          t.__v != n.__v && (p.props = k, p.state = p.__s, p.__g &= -9), t.__e = n.__e, t.__k = n.__k, t.__k.some(function(V) {
            V && (V.__ = t);
          }), jn.push.apply(p.__h, p.__k), p.__k = [], p.__h.length && s.push(p), l = ot(n);
          break e;
        }
        p.componentWillUpdate && p.componentWillUpdate(k, p.__s, I), b && p.componentDidUpdate && p.__h.push(function() {
          p.componentDidUpdate(_, w, S);
        });
      } else b && !L.getDerivedStateFromProps && p.componentWillMount && p.componentWillMount(), b && p.componentDidMount && p.__h.push(p.componentDidMount);
      p.context = I, p.props = k, p.__P = e, p.__g &= -5, et = $.__r, tt = b ? 25 : 0;
      do {
        p.__g &= -9, et && et(t), c = p.render(p.props, p.state = p.__s, p.context);
      } while (8 & p.__g && ++tt < 25);
      b && (jn.push.apply(p.__h, p.__k), p.__k = []), p.state = p.__s, p.getChildContext && (o = _t({}, o, p.getChildContext())), b && n.__c && p.getSnapshotBeforeUpdate && (S = p.getSnapshotBeforeUpdate(_, w)), Ce = c && c.type === X && null == c.key ? c.props.children : c, k.__P && (c = l, r = (e = k.__P).namespaceURI, d = i = null, n.props && n.props.__P != e && (n.__k.some(function(V) {
        V && zo(V, V);
      }), n.__k = null), l = n.__k ? ot(n, 0) : null), l = Zr(e, Uo(Ce) ? Ce : [Ce], t, n, o, r, i, s, l, d, u), k.__P && (t.__e = null, l = c), t.__u &= -161, f && f.some(yt), p.__h.length && s.push(p), 1 & p.__g && (p.__g &= -4);
    } catch (V) {
      if (s.length = m, t.__v = null, d || i) if (V && V.then) {
        if (t.__u |= 128 | d, i) {
          for (~(g = i.indexOf(l || void 0)) || (g = i.length); (P = i[g - 1]) && 8 == P.nodeType; ) g--;
          for (; g < i.length; g++) if (P = i[g]) if (i[g] = null, ye) {
            if (P == h) break;
          } else {
            if (8 != P.nodeType) break;
            P.data.startsWith("$s") && (h = Nn(ye = P));
          }
        }
        if (!ye) {
          for (; l && 8 == l.nodeType && l.nextSibling; ) l = l.nextSibling;
          ye = l;
        }
        (c = Nn(ye = t.__c.__z || (t.__c.__z = ye))) ? (t.__e = ye, l = c) : t.__e = l, l = l && l.nextSibling;
      } else i && i.some(yt);
      else t.__e = n.__e;
      t.__k || (t.__k = n.__k || []), V && V.then || ti(t), $.__e(V, t, n);
    }
  } else l = t.__e = Ls(n.__e, t, n, o, r, i, s, d, u, e);
  return (c = $.diffed) && c(t), l;
}
function Nn(e, t) {
  if (e && 8 == e.nodeType && e.data.startsWith("$s")) for (var n = 1; e = e.nextSibling; ) {
    if (8 == e.nodeType) {
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
  for (var o = 0; o < n.length; ) Bo(n[o++], n[o++], n[o++]);
  $.__c && $.__c(t, e), e.some(function(r) {
    try {
      e = r.__h, r.__h = [], e.some(function(i) {
        i.call(r);
      });
    } catch (i) {
      $.__e(i, r.__v);
    }
  });
}
function Ls(e, t, n, o, r, i, s, l, d, u) {
  var c, f, m, p, _, w, S, k, b = n.props || Un, D = t.props, I = t.type;
  if ("svg" == I ? r = "http://www.w3.org/2000/svg" : "math" == I ? r = "http://www.w3.org/1998/Math/MathML" : r || (r = "http://www.w3.org/1999/xhtml"), i) {
    for (c = 0; c < i.length; c++) if ((_ = i[c]) && (I ? _.localName == I : 3 == _.nodeType)) {
      e = _, i[c] = null;
      break;
    }
  }
  if (!e) {
    if (k = u.ownerDocument || document, !I) return k.createTextNode(D);
    e = k.createElementNS(r, I, D.is ? D : u), l && ($.__m && $.__m(t, i), l = false), i = null;
  }
  if (I) {
    if (u = "template" == I && e.content || e, i = "textarea" == I && null != D.defaultValue ? null : i && jo.call(u.childNodes), !l && i) for (b = {}, c = 0; c < e.attributes.length; c++) b[(_ = e.attributes[c]).name] = _.value;
    for (c in b) _ = b[c], "dangerouslySetInnerHTML" == c ? m = _ : "children" == c || c in D || "value" == c && "defaultValue" in D || "checked" == c && "defaultChecked" in D || Kn(e, c, null, _, r);
    for (c in D) _ = D[c], "children" == c ? p = _ : "dangerouslySetInnerHTML" == c ? f = _ : "value" == c ? w = _ : "checked" == c ? S = _ : l && "function" != typeof _ || b[c] === _ || Kn(e, c, _, b[c], r);
    f ? (l || m && (f.__html == m.__html || f.__html == e.innerHTML) || (e.innerHTML = f.__html), t.__k = []) : (m && (e.textContent = ""), ("foreignObject" == I || "http://www.w3.org/1998/Math/MathML" == r && Cs.test(I)) && (r = "http://www.w3.org/1999/xhtml"), Zr(u, Uo(p) ? p : [p], t, n, o, r, i, s, i ? i[0] : n.__k && ot(n, 0), l, d), i && i.some(yt)), l && "textarea" != I || (c = "value", "progress" == I && null == w ? e.removeAttribute(c) : null == w || w === e[c] && ("progress" != I || w) || Kn(e, c, w, b[c], r), c = "checked", null != S && S != e[c] && Kn(e, c, S, b[c], r));
  } else b === D || l && e.data == D || (e.data = D);
  return e;
}
function Bo(e, t, n, o) {
  try {
    "function" == typeof e ? t ? t.__x = e(t) || 1 : o && (o = o.__c || o.__e) && (t = o.__x) && (o.__x = null, "function" == typeof t ? t() : e(null)) : e.current = t;
  } catch (r) {
    $.__e(r, n);
  }
}
function zo(e, t, n) {
  var o, r, i, s;
  if ($.unmount && $.unmount(e), !(o = e.ref) || o.current && o.current != e.__e || Bo(o, null, t, e), o = e.__c) {
    if (o.componentWillUnmount) try {
      o.componentWillUnmount();
    } catch (l) {
      $.__e(l, t);
    }
    o.__P = o.__n = null;
  }
  if (o = e.__k) for (s = 0; s < o.length; s++) o[s] && zo(o[s], t, "function" != typeof e.type || n && !e.props.__P);
  !n && (o = e.__c) && (o = o.__z) && (r = Nn(o, i = [])) && (o == e.__e && i.some(yt), yt(r), yt(o)), n || yt(e.__e), e.__e = e.__c = e.__ = null;
}
function Vs(e, t, n) {
  return this.constructor(e, n);
}
function oi(e, t) {
  var n, o, r, i;
  $.__ && $.__(e, t), 9 == t.nodeType && (t = t.documentElement), o = (n = e && 32 & e.__u) ? null : t.__k, t.__k = nn(X, { children: [e] }), r = [], i = [], Wo(t, t.__k, o || Un, Un, t.namespaceURI, o ? null : t.firstChild ? jo.call(t.childNodes) : null, r, o ? o.__e : t.firstChild, n, i), ni(r, t.__k, i), t.__k.props.children = null;
}
$ = { __e: function(e, t, n, o) {
  for (var r, i, s; t = t.__; ) if ((r = t.__c) && !(1 & r.__g)) {
    r.__g |= 4;
    try {
      if ((s = (i = r.constructor) && i.getDerivedStateFromError) && r.setState(i.getDerivedStateFromError(e)), r.componentDidCatch && (r.componentDidCatch(e, o || {}), s = 1), s && 8 & r.__g) return void (r.__g |= 2);
    } catch (l) {
      e = l;
    }
  }
  throw qn = 0, e;
} }, zr = 0, No = function(e) {
  return null != e && e.constructor === on;
}, Rt.prototype.setState = function(e, t) {
  var n = this.__s;
  n && n != this.state || (n = this.__s = _t({}, this.state)), "function" == typeof e && (e = e(_t({}, n), this.props)), e && (_t(n, e), this.__v && (t && this.__k.push(t), Wr(this)));
}, Rt.prototype.forceUpdate = function(e) {
  this.__v && (this.__g |= 4, e && this.__h.push(e), Wr(this));
}, Rt.prototype.render = X, nt = [], qn = 0, Gr = function(e, t) {
  return e.__v.__b - t.__v.__b;
}, Fn = /* @__PURE__ */ Symbol(), Xr = /(PointerCapture)$|Capture$/i, qo = 0, Fo = {}, Ms = 0;

// node_modules/preact/hooks/dist/hooks.mjs
var Wn;
var ce;
var Go;
var ri;
var Is = Object.is;
var Xo = 0;
var fi = [];
var Yo = [];
var Z = $;
var ii = Z.__b;
var ai = Z.__r;
var si = Z.diffed;
var li = Z.__c;
var ui = Z.unmount;
var ci = Z.__;
function mi(e, t) {
  Z.__h && Z.__h(ce, e, Xo || t), Xo = 0;
  var n = ce.__H || (ce.__H = { __: [], __h: [] });
  return e >= n.__.length && n.__.push({}), n.__[e];
}
function Ie(e, t) {
  var n = mi(Wn++, 3);
  !Z.__s && hi(n.__H, t) && (n.__P = true, n.__ = e, n.u = t, ce.__H.__h.push(n));
}
function ee(e) {
  return Xo = 5, an(function() {
    return { current: e };
  }, []);
}
function an(e, t) {
  var n = mi(Wn++, 7);
  return hi(n.__H, t) && (n.__ = e(), n.__H = t), n.__;
}
function Rs() {
  var e;
  do {
    for (; e = Yo.shift(); ) try {
      rn(e);
    } catch (n) {
      Z.__e(n, { __: (e = e.__P) && e.__v });
    }
    for (; e = fi.shift(); ) {
      var t = e.__H;
      if (e.__P && t) try {
        t.__h.some(rn), t.__h.some(Jo), t.__h = [];
      } catch (n) {
        t.__h = [], Z.__e(n, e.__v);
      }
    }
  } while (Yo.length);
}
Z.__b = function(e) {
  ce = null, ii && ii(e);
}, Z.__ = function(e, t) {
  e && t.__k && t.__k.__m && (e.__m = t.__k.__m), ci && ci(e, t);
}, Z.__r = function(e) {
  ai && ai(e), Wn = 0;
  var t = (ce = e.__c).__H;
  t && (Go == ce ? ce.__h = [] : (t.__h.some(rn), t.__h.some(Jo), Wn = 0), t.__h = [], t.__.some(function(n) {
    n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
  })), Go = ce;
}, Z.diffed = function(e) {
  si && si(e);
  var t = e.__c;
  t && t.__H && (t.__H.__h.length && di(fi.push(t)), t.__H.__.some(function(n) {
    n.u && (n.__H = n.u);
  })), Go = ce = null;
}, Z.__c = function(e, t) {
  t.some(function(n) {
    try {
      n.__h.some(rn), n.__h = n.__h.filter(function(o) {
        return !o.__ || Jo(o);
      });
    } catch (o) {
      n.__h = [function() {
        throw o;
      }];
    }
  }), li && li(e, t);
}, Z.unmount = function(e) {
  ui && ui(e);
  var t, n, o = e.__c;
  o && o.__H && (o.__H.__.some(function(r) {
    try {
      if (r.__P && r.__c) {
        if (void 0 === n) {
          for (n = e.__; n && (!n.__c || !n.__c.__P); ) n = n.__;
          n = n && n.__c;
        }
        r.__P = n, di(Yo.push(r));
      } else rn(r);
    } catch (i) {
      t = i;
    }
  }), o.__H = void 0, t && Z.__e(t, o.__v));
};
var pi = "function" == typeof requestAnimationFrame;
function As(e) {
  var t, n = function() {
    clearTimeout(o), pi && cancelAnimationFrame(t), setTimeout(e);
  }, o = setTimeout(n, 35);
  pi && (t = requestAnimationFrame(n));
}
function di(e) {
  1 != e && ri == Z.requestAnimationFrame || ((ri = Z.requestAnimationFrame) || As)(Rs);
}
function rn(e) {
  var t = ce, n = e.__c;
  "function" == typeof n && (e.__c = void 0, n()), ce = t;
}
function Jo(e) {
  var t = ce;
  e.__c = e.__(), ce = t;
}
function hi(e, t) {
  return !e || e.length != t.length || t.some(function(n, o) {
    return !Is(n, e[o]);
  });
}

// node_modules/@preact/signals-core/dist/signals-core.module.js
var Hs = /* @__PURE__ */ Symbol.for("preact-signals");
function Xn() {
  if (!(qe > 1)) {
    var e, t = false;
    !(function() {
      var r = zn;
      zn = void 0;
      while (void 0 !== r) {
        var i = r.S;
        if (i.v === r.v) {
          for (var s = i.t; void 0 !== s; s = s.x) if (s.i === r.i) s.i = i.i;
        }
        r = r.o;
      }
    })();
    while (void 0 !== ln) {
      var n = ln;
      ln = void 0;
      Bn++;
      while (void 0 !== n) {
        var o = n.u;
        n.u = void 0;
        n.f &= -3;
        if (!(8 & n.f) && gi(n)) try {
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
    Bn = 0;
    qe--;
    if (t) throw e;
  } else qe--;
}
function Yn(e) {
  if (qe > 0) return e();
  Qo = ++Ds;
  qe++;
  try {
    return e();
  } finally {
    Xn();
  }
}
var sn;
var N = void 0;
function se(e) {
  var t = N, n = sn;
  N = void 0;
  sn = void 0;
  try {
    return e();
  } finally {
    N = t;
    sn = n;
  }
}
var ln = void 0;
var qe = 0;
var Bn = 0;
var Ds = 0;
var Qo = 0;
var zn = void 0;
var Gn = 0;
function vi(e) {
  if (void 0 !== N) {
    var t = e.n;
    if (void 0 === t || t.t !== N) {
      t = { i: 0, S: e, p: N.s, n: void 0, t: N, e: void 0, x: void 0, r: t };
      if (void 0 !== N.s) N.s.n = t;
      N.s = t;
      e.n = t;
      if (32 & N.f) e.S(t);
      return t;
    } else if (-1 === t.i) {
      t.i = 0;
      if (void 0 !== t.n) {
        t.n.p = t.p;
        if (void 0 !== t.p) t.p.n = t.n;
        t.p = N.s;
        t.n = void 0;
        N.s.n = t;
        N.s = t;
      }
      return t;
    }
  }
}
function ne(e, t) {
  this.v = e;
  this.i = 0;
  this.n = void 0;
  this.t = void 0;
  this.l = 0;
  this.W = null == t ? void 0 : t.watched;
  this.Z = null == t ? void 0 : t.unwatched;
  this.name = null == t ? void 0 : t.name;
}
ne.prototype.brand = Hs;
ne.prototype.h = function() {
  return true;
};
ne.prototype.S = function(e) {
  var t = this, n = this.t;
  if (n !== e && void 0 === e.e) {
    e.x = n;
    this.t = e;
    if (void 0 !== n) n.e = e;
    else se(function() {
      var o;
      null == (o = t.W) || o.call(t);
    });
  }
};
ne.prototype.U = function(e) {
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
      if (void 0 === o) se(function() {
        var r;
        null == (r = t.Z) || r.call(t);
      });
    }
  }
};
ne.prototype.subscribe = function(e) {
  var t = this;
  return T(function() {
    var n = t.value;
    se(function() {
      return e(n);
    });
  }, { name: "sub" });
};
ne.prototype.valueOf = function() {
  return this.value;
};
ne.prototype.toString = function() {
  return this.value + "";
};
ne.prototype.toJSON = function() {
  return this.value;
};
ne.prototype.peek = function() {
  var e = this;
  return se(function() {
    return e.value;
  });
};
Object.defineProperty(ne.prototype, "value", { get: function() {
  var e = vi(this);
  if (void 0 !== e) e.i = this.i;
  return this.v;
}, set: function(e) {
  if (e !== this.v) {
    if (Bn > 100) throw new Error("Cycle detected");
    !(function(n) {
      if (0 !== qe && 0 === Bn) {
        if (n.l !== Qo) {
          n.l = Qo;
          zn = { S: n, v: n.v, i: n.i, o: zn };
        }
      }
    })(this);
    this.v = e;
    this.i++;
    Gn++;
    qe++;
    try {
      for (var t = this.t; void 0 !== t; t = t.x) t.t.N();
    } finally {
      Xn();
    }
  }
} });
function v(e, t) {
  return new ne(e, t);
}
function gi(e) {
  for (var t = e.s; void 0 !== t; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return true;
  return false;
}
function bi(e) {
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
function yi(e) {
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
function kt(e, t) {
  ne.call(this, void 0, t);
  this.x = e;
  this.s = void 0;
  this.g = Gn - 1;
  this.f = 4;
}
kt.prototype = new ne();
kt.prototype.h = function() {
  this.f &= -3;
  if (1 & this.f) return false;
  if (32 == (36 & this.f)) return true;
  this.f &= -5;
  if (this.g === Gn) return true;
  this.g = Gn;
  this.f |= 1;
  if (this.i > 0 && !gi(this)) {
    this.f &= -2;
    return true;
  }
  var e = N;
  try {
    bi(this);
    N = this;
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
  N = e;
  yi(this);
  this.f &= -2;
  return true;
};
kt.prototype.S = function(e) {
  if (void 0 === this.t) {
    this.f |= 36;
    for (var t = this.s; void 0 !== t; t = t.n) t.S.S(t);
  }
  ne.prototype.S.call(this, e);
};
kt.prototype.U = function(e) {
  if (void 0 !== this.t) {
    ne.prototype.U.call(this, e);
    if (void 0 === this.t) {
      this.f &= -33;
      for (var t = this.s; void 0 !== t; t = t.n) t.S.U(t);
    }
  }
};
kt.prototype.N = function() {
  if (!(2 & this.f)) {
    this.f |= 6;
    for (var e = this.t; void 0 !== e; e = e.x) e.t.N();
  }
};
Object.defineProperty(kt.prototype, "value", { get: function() {
  if (1 & this.f) throw new Error("Cycle detected");
  var e = vi(this);
  this.h();
  if (void 0 !== e) e.i = this.i;
  if (16 & this.f) throw this.v;
  return this.v;
} });
function Y(e, t) {
  return new kt(e, t);
}
function _i(e) {
  var t = e.j;
  e.j = void 0;
  if ("function" == typeof t) {
    qe++;
    var n = N;
    N = void 0;
    try {
      t();
    } catch (o) {
      e.f &= -2;
      e.f |= 8;
      Zo(e);
      throw o;
    } finally {
      N = n;
      Xn();
    }
  }
}
function Zo(e) {
  for (var t = e.s; void 0 !== t; t = t.n) t.S.U(t);
  e.x = void 0;
  e.s = void 0;
  _i(e);
}
function Os(e) {
  if (N !== this) throw new Error("Out-of-order effect");
  yi(this);
  N = e;
  this.f &= -2;
  try {
    if (8 & this.f) Zo(this);
  } finally {
    Xn();
  }
}
function At(e, t) {
  this.x = e;
  this.j = void 0;
  this.s = void 0;
  this.u = void 0;
  this.f = 32;
  this.name = null == t ? void 0 : t.name;
  if (sn) sn.push(this);
}
At.prototype.c = function() {
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
At.prototype.S = function() {
  if (1 & this.f) throw new Error("Cycle detected");
  this.f |= 1;
  this.f &= -9;
  _i(this);
  bi(this);
  qe++;
  var e = N;
  N = this;
  return Os.bind(this, e);
};
At.prototype.N = function() {
  if (!(2 & this.f)) {
    this.f |= 2;
    this.u = ln;
    ln = this;
  }
};
At.prototype.d = function() {
  this.f |= 8;
  if (!(1 & this.f)) Zo(this);
};
At.prototype.dispose = function() {
  this.d();
};
function T(e, t) {
  var n = new At(e, t);
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
var er;
var Ht;
var Jn;
var Ks = "undefined" != typeof window && !!window.__PREACT_SIGNALS_DEVTOOLS__;
var ki = [];
var wi = [];
T(function() {
  er = this.N;
})();
function Dt(e, t) {
  $[e] = t.bind(null, $[e] || function() {
  });
}
function un(e) {
  if (Jn) {
    var t = Jn;
    Jn = void 0;
    t();
  }
  Jn = e && e.S();
}
function xi(e) {
  var t = this, n = e.data, o = rt(n);
  o.name = "ReactiveDom";
  o.value = n;
  var r = an(function() {
    var l = t, d = t.__v;
    while (d = d.__) if (d.__c) {
      d.__c.__$f |= 4;
      break;
    }
    var u = Y(function() {
      var p = o.value.value;
      return 0 === p ? 0 : true === p ? "" : p || "";
    }), c = Y(function() {
      return !Array.isArray(u.value) && !No(u.value);
    }), f = T(function() {
      this.N = Si;
      if (c.value) {
        var p = u.value;
        if (l.__v && l.__v.__e && 3 === l.__v.__e.nodeType) l.__v.__e.data = p;
      }
    }), m = t.__$u.d;
    t.__$u.d = function() {
      f();
      m.call(this);
    };
    return [c, u];
  }, []), i = r[0], s = r[1];
  return i.value ? s.peek() : s.value;
}
xi.displayName = "ReactiveTextNode";
Object.defineProperties(ne.prototype, { constructor: { configurable: true, value: Yr(X, null).constructor }, type: { configurable: true, value: xi }, props: { configurable: true, get: function() {
  var e = this;
  return { data: { get value() {
    return e.value;
  } } };
} }, __b: { configurable: true, value: 1 } });
Dt("__b", function(e, t) {
  un();
  Ht = void 0;
  if ("string" == typeof t.type) {
    var n, o = t.props;
    for (var r in o) if ("children" !== r) {
      var i = o[r];
      if (i instanceof ne) {
        if (!n) t.__np = n = {};
        n[r] = i;
        o[r] = i.peek();
      }
    }
  }
  e(t);
});
Dt("__r", function(e, t) {
  e(t);
  if (t.type !== X) {
    un();
    var n, o = t.__c;
    if (o) {
      o.__$f &= -2;
      if (void 0 === (n = o.__$u)) o.__$u = n = (function(r, i) {
        var s;
        T(function() {
          s = this;
        }, { name: i });
        s.c = r;
        return s;
      })(/* @__PURE__ */ (function(r) {
        return function() {
          var i;
          if (Ks) null == (i = this.y) || i.call(this);
          r.__$f |= 1;
          r.setState({});
        };
      })(o), "function" == typeof t.type ? t.type.displayName || t.type.name : "");
    }
    Ht = o;
    un(n);
  }
});
Dt("__e", function(e, t, n, o) {
  un();
  Ht = void 0;
  e(t, n, o);
});
Dt("diffed", function(e, t) {
  un();
  Ht = void 0;
  var n;
  if ("string" == typeof t.type && (n = t.__e)) {
    var o = t.__np, r = t.props, i = n.U;
    if (i) for (var s in i) {
      var l = i[s];
      if (!(void 0 === l || o && s in o)) {
        l.d();
        i[s] = void 0;
      }
    }
    if (o) {
      if (!i) {
        i = {};
        n.U = i;
      }
      for (var d in o) {
        var u = i[d], c = o[d];
        if (void 0 === u) {
          u = Fs(n, d, c, r);
          i[d] = u;
        } else u.o(c, r);
      }
    }
  }
  e(t);
});
function Fs(e, t, n, o) {
  var r = t in e && void 0 === e.ownerSVGElement, i = v(n);
  return { o: function(s, l) {
    i.value = s;
    o = l;
  }, d: T(function() {
    this.N = Si;
    var s = i.value.value;
    if (o[t] !== s) {
      o[t] = s;
      if (r) e[t] = s;
      else if (null != s && (false !== s || "-" === t[4])) e.setAttribute(t, s);
      else e.removeAttribute(t);
    }
  }) };
}
Dt("unmount", function(e, t) {
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
    var s = t.__np;
    if (s) {
      var l = t.props;
      for (var d in s) l[d] = s[d];
    }
    t.__np = void 0;
  } else {
    var u = t.__c;
    if (u) {
      u.__$f |= 8;
      var c = u.__$u;
      if (c) {
        u.__$u = void 0;
        c.d();
      }
    }
  }
  e(t);
});
Dt("__h", function(e, t, n, o) {
  if (o < 3) t.__$f |= 2;
  e(t, n, o);
});
Rt.prototype.shouldComponentUpdate = function(e, t) {
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
  for (var s in e) if ("__source" !== s && e[s] !== this.props[s]) return true;
  for (var l in this.props) if (!(l in e)) return true;
  return false;
};
function rt(e, t) {
  return an(function() {
    return v(e, t);
  }, []);
}
function Ns(e, t) {
  var n = ee(e);
  n.current = e;
  Ht.__$f |= 4;
  return an(function() {
    return Y(function() {
      return n.current();
    }, t);
  }, []);
}
var qs = "undefined" == typeof requestAnimationFrame ? setTimeout : function(e) {
  var t = function() {
    clearTimeout(n);
    cancelAnimationFrame(o);
    e();
  }, n = setTimeout(t, 35), o = requestAnimationFrame(t);
};
var Us = function(e) {
  queueMicrotask(function() {
    queueMicrotask(e);
  });
};
function js() {
  Yn(function() {
    var e;
    while (e = ki.shift()) er.call(e);
  });
}
function Ws() {
  if (1 === ki.push(this)) ($.requestAnimationFrame || qs)(js);
}
function Bs() {
  Yn(function() {
    var e;
    while (e = wi.shift()) er.call(e);
  });
}
function Si() {
  if (1 === wi.push(this)) ($.requestAnimationFrame || Us)(Bs);
}
function tr(e, t) {
  var n = ee(e);
  n.current = e;
  var o = Ht;
  Ie(function() {
    return T(function() {
      this.N = Ws;
      if (!(o && 8 & o.__$f)) return n.current();
    }, t);
  }, []);
}

// src/vec.ts
var C = (e, t) => [e[0] + t[0], e[1] + t[1], e[2] + t[2]];
var H = (e, t) => [e[0] - t[0], e[1] - t[1], e[2] - t[2]];
var x = (e, t) => [e[0] * t, e[1] * t, e[2] * t];
var W = (e, t) => e[0] * t[0] + e[1] * t[1] + e[2] * t[2];
var he = (e, t) => [
  e[1] * t[2] - e[2] * t[1],
  e[2] * t[0] - e[0] * t[2],
  e[0] * t[1] - e[1] * t[0]
];
var it = (e) => Math.hypot(e[0], e[1], e[2]);
var Ue = (e, t) => it(H(e, t));
var zs = (e, t, n) => C(x(e, 1 - n), x(t, n));
function J(e, t = [0, 0, 1]) {
  const n = it(e);
  return n > 1e-12 ? x(e, 1 / n) : t;
}
function Ot(e) {
  const t = Math.abs(e[0]) < 0.7 * it(e) ? [1, 0, 0] : [0, 1, 0];
  return J(he(t, e));
}
function Qn(e, t, n) {
  const o = Math.cos(n);
  const r = Math.sin(n);
  return C(C(x(e, o), x(he(t, e), r)), x(t, W(t, e) * (1 - o)));
}
function cn([e, t]) {
  return Array.from({ length: 8 }, (n, o) => [
    o & 1 ? t[0] : e[0],
    o & 2 ? t[1] : e[1],
    o & 4 ? t[2] : e[2]
  ]);
}
var wt = ([e, t]) => zs(e, t, 0.5);

// src/camera.ts
var nr = Math.PI / 180;
var Zn = 89 * nr;
function pn(e, t, n) {
  const o = J(H(e.target, e.eye), [0, 0, -1]);
  const r = J(he(o, e.up), Ot(o));
  const i = he(r, o);
  const s = e.height != null && e.height > 0;
  const l = s ? e.height / n : 2 * Math.tan(e.fov * nr * 0.5) / n;
  return { eye: e.eye, forward: o, side: r, up: i, width: t, height: n, pixel: l, parallel: s };
}
function eo(e, t) {
  const n = H(t, e.eye);
  const o = W(n, e.forward);
  const r = e.parallel ? e.pixel : e.pixel * o;
  return [e.width / 2 + W(n, e.side) / r, e.height / 2 - W(n, e.up) / r, o];
}
function Tu(e, t, n) {
  const o = (t - e.width / 2) * e.pixel;
  const r = (e.height / 2 - n) * e.pixel;
  const i = C(x(e.side, o), x(e.up, r));
  if (e.parallel) return { origin: C(e.eye, i), direction: e.forward };
  return { origin: e.eye, direction: J(C(e.forward, i)) };
}
function Pu(e, t) {
  return e.parallel ? e.pixel : e.pixel * Math.max(W(H(t, e.eye), e.forward), 1e-3);
}
function Mi(e, t, n, o) {
  const r = H(e.target, e.eye);
  const i = Math.max(it(r), 1e-3);
  const s = Math.asin(Math.max(-1, Math.min(1, W(J(r), t))));
  const l = H(r, x(t, W(r, t)));
  const d = J(it(l) > 1e-6 * i ? l : H(e.up, x(t, W(e.up, t))), Ot(t));
  const u = Math.max(-Zn, Math.min(Zn, s + o));
  const c = Qn(d, t, n);
  const f = C(x(c, Math.cos(u)), x(t, Math.sin(u)));
  return { ...e, up: t, target: C(e.eye, x(f, i)) };
}
function Ci(e, t, n, o, r) {
  const i = H(e.target, e.eye);
  const s = H(i, x(t, W(i, t)));
  const l = J(it(s) > 1e-6 ? s : e.up, Ot(t));
  const d = J(he(l, t));
  const u = C(C(x(l, n), x(d, o)), x(t, r));
  return at(e, u);
}
function $i(e, t, n, o, r) {
  const i = J(H(e.target, e.eye));
  const s = J(he(i, e.up), Ot(i));
  return at(e, C(C(x(i, n), x(s, o)), x(t, r)));
}
function at(e, t) {
  return { ...e, eye: C(e.eye, t), target: C(e.target, t) };
}
function Ei(e, t, n, o, r) {
  const i = J(H(e.target, e.eye));
  const s = Math.asin(Math.max(-1, Math.min(1, W(i, t))));
  const l = Math.max(-Zn, Math.min(Zn, s + r));
  const d = J(he(i, t), J(he(i, e.up), Ot(i)));
  const u = (c) => Qn(Qn(c, d, l - s), t, o);
  return {
    ...e,
    up: t,
    eye: C(n, u(H(e.eye, n))),
    target: C(n, u(H(e.target, n)))
  };
}
function Ti(e, t, n, o, r) {
  const i = t.parallel ? t.pixel : t.pixel * r;
  return at(e, C(x(t.side, -n * i), x(t.up, o * i)));
}
function to(e, t, n, o, r) {
  const i = H(t, e.eye);
  const s = it(i);
  if (s < 1e-9) return e;
  let l = s * (1 - n);
  if (r) l = Math.sign(l) * Math.max(Math.abs(l), 0.5 * Math.abs(1 - n));
  else if (l > 0) l = Math.max(0, Math.min(l, s - o));
  return at(e, x(i, l / s));
}
function no(e, t, n, o, r) {
  const i = Math.max(0.05, Math.min(1e5, (e.height ?? 1) * r));
  const s = (1 - i / (e.height ?? 1)) * t.pixel;
  const l = C(
    x(t.side, (n - t.width / 2) * s),
    x(t.up, (t.height / 2 - o) * s)
  );
  return { ...at(e, l), height: i };
}
function Pi(e, t, n = 0.4) {
  const o = wt(t);
  const r = Math.max(Ue(t[0], t[1]) / 2, 0.15);
  const i = J(H(e.eye, e.target));
  if (e.height) {
    const l = W(H(e.eye, o), i);
    return { ...e, eye: C(o, x(i, l)), target: o, height: r * 3 };
  }
  const s = Math.max(1.5 * r / Math.tan(e.fov * nr * 0.5), n + r);
  return { ...e, eye: C(o, x(i, s)), target: o };
}
var Li = ["plan", "ceiling", "north", "east", "south", "west"];
function Gs(e) {
  const t = Math.abs(e[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
  const n = J(he(e, t));
  return { right: J(he(n, e)), ahead: n };
}
function Vi(e, t, n, o) {
  const { right: r, ahead: i } = Gs(n);
  const s = wt(t);
  const l = (_) => Math.abs(W(H(t[1], t[0]), _));
  const d = {
    plan: { forward: x(n, -1), up: i, side: r, cut: 0.15 },
    ceiling: { forward: n, up: x(i, -1), side: r, cut: 0.35 },
    north: { forward: i, up: n, side: r, cut: 0.25 },
    south: { forward: x(i, -1), up: n, side: r, cut: 0.25 },
    east: { forward: r, up: n, side: i, cut: 0.25 },
    west: { forward: x(r, -1), up: n, side: i, cut: 0.25 }
  };
  const u = d[e];
  const c = l(u.forward);
  const f = 1;
  const m = H(s, x(u.forward, c / 2 + f));
  const p = 1.08 * Math.max(l(u.up), l(u.side) / o, 0.1);
  return { eye: m, target: s, up: u.up, fov: 50, height: p, near: f + c * u.cut };
}
function dn(e, t) {
  const n = (r, i) => Ue(r, i) < 1e-4;
  const o = (r, i) => Math.abs((r ?? -1) - (i ?? -1)) < 1e-4;
  return n(e.eye, t.eye) && n(e.target, t.target) && n(e.up, t.up) && o(e.fov, t.fov) && o(e.height, t.height) && o(e.near, t.near);
}

// src/counters.ts
var Ii = 1024;
var le = {
  frame: 0,
  seqApplied: 0,
  frames: [],
  sent: [],
  entered: 0,
  firstDrawn: 0
};
var Ri = 0;
for (const e of ["input", "pointermove", "pointerdown", "keydown", "wheel"]) {
  addEventListener(e, (t) => Ri = t.timeStamp, { capture: true, passive: true });
}
function Ai(e, t) {
  le.sent.push({ seq: e, what: t, at: performance.now(), input: Ri });
  if (le.sent.length > Ii) le.sent.shift();
}
function Hi(e) {
  le.frame = e.frame;
  le.seqApplied = e.seq;
  le.firstDrawn ||= e.drawn;
  le.frames.push(e);
  if (le.frames.length > Ii) le.frames.shift();
  requestAnimationFrame(() => {
    const t = new MessageChannel();
    t.port1.onmessage = () => {
      e.painted = performance.now();
      t.port1.close();
    };
    t.port2.postMessage(0);
  });
}
window.__desk = le;

// src/store.ts
var oo = /* @__PURE__ */ new Set();
var Kt = (e) => typeof e === "object" && e !== null && !Array.isArray(e);
function hn(e, t) {
  if (!Kt(e) || !Kt(t)) return t;
  const n = { ...e };
  for (const [o, r] of Object.entries(t)) n[o] = hn(n[o], r);
  return n;
}
var fn = class {
  constructor(t) {
    this.server = t;
    this.shown = v(t);
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
      this.own.set(o, { value: hn(i, r), seq: n });
    }
    oo.add(this);
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
    if (this.own.size === 0) oo.delete(this);
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
var Re = class {
  /** Numbers of the entries there are, ascending; changes only when one comes or goes. */
  ids = v([]);
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
    for (const [o, r] of Object.entries(t ?? {})) n.set(Number(o), new fn(r));
    this.entries = n;
    this.number();
  }
  patch(t) {
    let n = false;
    for (const [o, r] of Object.entries(t)) {
      const i = Number(o);
      const s = this.entries.get(i);
      if (r === null) n = this.entries.delete(i) || n;
      else if (s) s.receive(r);
      else {
        this.entries.set(i, new fn(r));
        n = true;
      }
    }
    if (n) this.number();
  }
  number() {
    this.ids.value = [...this.entries.keys()].sort((t, n) => t - n);
  }
};
var y = new Re();
var K = new Re();
var pe = new Re();
var vn = new Re();
var st = new Re();
var lt = new Re();
var ve = new Re();
var $e = new Re();
var mn = {
  lamps: y,
  groups: K,
  things: pe,
  materials: vn,
  views: st,
  looks: lt,
  meters: ve,
  grids: $e
};
var z = v(null);
var ro = v([]);
var Ee = v([]);
var je = v({ undo: null, redo: null, steps: 0 });
var xt = v({ state: "clean", file: "" });
var re = v({ you: true, name: null });
var ge = v(null);
var io = new fn({
  ev: 0,
  metered: null,
  tone: "filmic",
  white: { kelvin: 6500, tint: 0 },
  false_color: null
});
var St = io.shown;
var or = {
  scene: z,
  layers: ro,
  solo: Ee,
  history: je,
  saved: xt,
  editor: re,
  status: ge
};
function Di(e) {
  oo.clear();
  for (const [t, n] of Object.entries(mn)) n.whole(e[t]);
  for (const [t, n] of Object.entries(or)) if (t in e) n.value = e[t];
  if (Kt(e.display)) io.receive(e.display);
}
function Oi(e, t) {
  for (const [n, o] of Object.entries(e)) {
    if (n in mn) mn[n].patch(o);
    else if (n === "display") io.receive(o);
    else if (n in or) or[n].value = o;
  }
  Ft(t);
}
function Ft(e) {
  for (const t of [...oo]) t.release(e);
}
function Ki(e, t) {
  for (const [n, o] of Object.entries(e)) {
    if (n in mn && Kt(o)) {
      for (const [r, i] of Object.entries(o)) {
        const s = mn[n].entry(Number(r));
        if (s && Kt(i)) t(s, i);
      }
    } else if (n === "display" && Kt(o)) {
      t(io, o);
    }
  }
}
var rr = (e, t) => Ki(e, (n, o) => n.keep(o, t));
var ao = (e, t) => Ki(e, (n, o) => n.settle(o, t));
function Te(e) {
  const t = K.get(e.group);
  const n = e.on && !e.parked && (t?.on ?? true);
  return n ? e.level * (t?.level ?? 1) : 0;
}
var Fi = Y(() => {
  const e = y.all();
  return e.length > 0 && e.every(([, t]) => Te(t) === 0);
});

// src/wire.ts
var Q = v("entering");
var yn = v(0);
var _e = v("edit");
var lr = v(null);
var We = v(0);
var Ni = () => null;
var qi = (e) => void (Ni = e);
var ar = /* @__PURE__ */ new Map();
var ut = null;
var gn = 0;
var ir = null;
var bn = 0;
var Nt = "";
var so = false;
function Ae(e, t) {
  const n = ar.get(e) ?? /* @__PURE__ */ new Set();
  ar.set(e, n.add(t));
  return () => n.delete(t);
}
function q(e) {
  if (!ut || ut.readyState !== WebSocket.OPEN || Q.peek() !== "open") return 0;
  gn += 1;
  ut.send(JSON.stringify({ ...e, seq: gn }));
  if (e.do !== "ack") Ai(gn, e.do);
  return gn;
}
var Xs = 0;
function ke(e, t, n) {
  const o = ++Xs;
  const r = Ae("answer", (i) => {
    if (i.id !== o) return;
    if (i.done !== false) r();
    n(i);
  });
  if (!q({ do: "ask", id: o, what: e, ...t })) r();
  return r;
}
function Ys(e) {
  switch (e.is) {
    case "hello":
      bn = 0;
      if (ir !== null && e.build !== ir) {
        Q.value = "renewed";
        ut?.close();
        return;
      }
      ir = e.build;
      _e.value = e.role === "watch" ? "watch" : "edit";
      lr.value = e.you ?? null;
      We.value = 0;
      Q.value = "open";
      break;
    case "state":
      Di(e.state ?? e);
      break;
    case "patch":
      sr(e.seq);
      Oi(e.patch ?? {}, We.value);
      break;
    case "status":
      ge.value = e;
      break;
    case "refused":
      sr(e.seq);
      Ft(We.value);
      break;
    case "event":
      if (e.what === "bye") so = true;
      break;
  }
  for (const t of [...ar.get(e.is) ?? []]) t(e);
}
function sr(e) {
  if (typeof e === "number" && e > We.value) We.value = e;
}
async function Ui() {
  if (!Nt) return "in";
  try {
    const e = await fetch("/enter", {
      method: "POST",
      headers: { "content-type": "application/json" },
      body: JSON.stringify({ key: Nt })
    });
    return e.ok ? "in" : "denied";
  } catch {
    return "away";
  }
}
function ji() {
  const e = location.protocol === "https:" ? "wss" : "ws";
  const t = new WebSocket(`${e}://${location.host}/wire`);
  t.binaryType = "arraybuffer";
  let n = false;
  ut = t;
  t.onmessage = (o) => {
    if (t !== ut) return;
    if (typeof o.data !== "string") {
      const i = Ni(o.data);
      if (i) sr(i.seq);
      return;
    }
    const r = JSON.parse(o.data);
    if (r.is === "hello") {
      n = true;
      gn = 0;
    }
    Ys(r);
  };
  t.onclose = () => {
    if (t !== ut) return;
    ut = null;
    if (Q.value !== "renewed") void Js(n);
  };
}
async function Js(e) {
  Ft(Infinity);
  if (!e && await Qs()) {
    const o = await Ui();
    if (o === "denied" || o === "in" && bn > 4 && !Nt) {
      Q.value = "denied";
      return;
    }
  }
  bn += 1;
  const t = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
  if (bn > 3 && t) so = true;
  Q.value = so ? "ended" : "lost";
  const n = Math.min(5, bn);
  for (let o = n; o > 0; o--) {
    yn.value = o;
    await new Promise((r) => setTimeout(r, 1e3));
  }
  yn.value = 0;
  ji();
}
async function Qs() {
  try {
    return (await fetch("/", { method: "HEAD", cache: "no-store" })).ok;
  } catch {
    return false;
  }
}
async function Wi() {
  const e = location.hash.slice(1);
  if (e) {
    Nt = e;
    sessionStorage.setItem("lampyris-key", Nt);
    window.history.replaceState(null, "", location.pathname + location.search);
  } else {
    Nt = sessionStorage.getItem("lampyris-key") ?? "";
  }
  le.entered = performance.now();
  if (e && await Ui() === "denied") {
    Q.value = "denied";
    return;
  }
  ji();
}
Ae("hello", () => so = false);

// src/frames.ts
var te = v(null);
var Ut = v(0);
var Bi = ["moving", "settled", "final"];
var zi = 32;
var qt = /* @__PURE__ */ new Map();
var He = null;
var ur = null;
var cr = false;
var Mt = null;
function Zs(e) {
  if (e.byteLength < zi) return null;
  const t = new DataView(e);
  const n = {
    frame: t.getUint32(0, true),
    seq: t.getUint32(4, true),
    camera: t.getUint32(8, true),
    width: t.getUint16(12, true),
    height: t.getUint16(14, true),
    kind: Bi[Math.min(t.getUint8(16), 2)],
    falseColor: (t.getUint8(18) & 1) === 1,
    batches: t.getUint32(20, true),
    error: t.getFloat32(24, true),
    light: t.getUint16(28, true) / 10,
    encode: t.getUint16(30, true) / 10
  };
  return { head: n, mime: t.getUint8(17) === 1 ? "image/png" : "image/jpeg" };
}
function el(e) {
  const t = Zs(e);
  if (!t) return null;
  if (Mt) q({ do: "ack", frame: Mt.head.frame });
  Mt = { ...t, bytes: e, received: performance.now() };
  if (!cr) void tl();
  return t.head;
}
async function tl() {
  cr = true;
  while (Mt) {
    const { head: e, mime: t, bytes: n, received: o } = Mt;
    Mt = null;
    try {
      const r = await createImageBitmap(new Blob([new Uint8Array(n, zi)], { type: t }));
      nl(e, r, n.byteLength, o);
    } catch {
    }
    q({ do: "ack", frame: e.frame });
  }
  cr = false;
}
function nl(e, t, n, o) {
  const r = performance.now();
  if (He && ur) {
    if (He.width !== t.width || He.height !== t.height) {
      He.width = t.width;
      He.height = t.height;
    }
    ur.drawImage(t, 0, 0);
  }
  t.close();
  const i = qt.get(e.camera) ?? te.peek()?.camera;
  if (i) te.value = { head: e, camera: i };
  ol();
  Hi({
    frame: e.frame,
    seq: e.seq,
    kind: Bi.indexOf(e.kind),
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
var lo = [];
function ol() {
  const e = performance.now();
  lo = lo.filter((t) => e - t < 1e3);
  lo.push(e);
  Ut.value = lo.length;
}
function pr(e) {
  He = e;
  ur = e?.getContext("2d", { alpha: false }) ?? null;
}
function Gi() {
  if (!He || !te.peek()) return null;
  const e = document.createElement("canvas");
  e.width = He.width;
  e.height = He.height;
  e.getContext("2d", { alpha: false })?.drawImage(He, 0, 0);
  return e;
}
qi(el);
Ae("camera", (e) => {
  qt.set(e.number, e);
  for (const t of qt.keys()) {
    if (qt.size <= 64) break;
    qt.delete(t);
  }
});
Ae("hello", () => {
  qt.clear();
  Mt = null;
});

// src/say.ts
var Ct = v([]);
var rl = 0;
function G(e, t = "plain") {
  const n = Ct.peek().find((r) => r.text === e);
  if (n) return;
  const o = ++rl;
  Ct.value = [...Ct.peek().slice(-2), { id: o, text: e, tone: t }];
  setTimeout(() => dr(o), t === "warn" ? 8e3 : 4e3);
}
function dr(e) {
  Ct.value = Ct.peek().filter((t) => t.id !== e);
}

// src/gesture.ts
var jt = 0;
var Yi = /* @__PURE__ */ new Set();
var Ji = (e) => void Yi.add(e);
var _n = /* @__PURE__ */ new Set();
function ue() {
  if (Q.value !== "open") return "There is no connection to the program: nothing was changed.";
  if (_e.value === "watch") return "You are watching. Ask for the pen to change things.";
  if (!re.value.you) return `${re.value.name ?? "Somebody else"} has the pen. Take it to change things.`;
  return null;
}
var Be = class {
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
    rr(t, Infinity);
    this.touched = hn(this.touched, t);
    this.waiting = hn(this.waiting ?? {}, t);
    if (this.under <= We.peek()) this.flush();
  }
  /** Any other message that belongs to this step. */
  also(t) {
    if (this.state === "over" || !this.begin()) return;
    this.flush();
    this.last = q(t);
  }
  end(t) {
    if (this.state === "held") {
      this.flush();
      ao(this.touched, this.last);
      this.finish({ do: "end", ...t ? { label: t } : {} });
    }
    this.state = "over";
  }
  cancel() {
    if (this.state === "held") {
      this.waiting = null;
      ao(this.touched, 0);
      this.finish({ do: "cancel" });
      Ft(0);
    }
    this.state = "over";
  }
  /** The server has followed so far. */
  followed() {
    if (this.waiting && this.under <= We.peek()) this.flush();
  }
  /** The line is gone, and with it what was held. */
  drop() {
    this.state = "over";
    _n.delete(this);
    jt = 0;
  }
  begin() {
    if (this.state === "held") return true;
    const t = se(ue);
    if (t) {
      G(t, "warn");
      this.state = "over";
      return false;
    }
    this.state = "held";
    _n.add(this);
    if (jt === 0) Yi.forEach((n) => n());
    if (jt++ === 0) this.last = q({ do: "begin", label: this.label });
    return true;
  }
  flush() {
    if (!this.waiting) return;
    this.under = this.last = q({ do: "set", patch: this.waiting });
    this.waiting = null;
  }
  finish(t) {
    _n.delete(this);
    jt = Math.max(0, jt - 1);
    if (jt === 0) q(t);
  }
};
function oe(e, t) {
  const n = new Be(e);
  n.set(t);
  n.end();
}
function uo(e, t) {
  const n = new Be(e);
  n.also(t);
  n.end();
}
function ze(e) {
  if (se(() => Q.value) !== "open") return;
  rr({ display: e }, Infinity);
  ao({ display: e }, q({ do: "display", patch: e }));
}
var De = null;
function Qi(e, t, n) {
  if (De && De.key !== e) Xi();
  De ??= { key: e, gesture: new Be(t), timer: 0 };
  De.gesture.set(n);
  clearTimeout(De.timer);
  De.timer = window.setTimeout(Xi, 700);
}
function Xi() {
  if (!De) return;
  clearTimeout(De.timer);
  De.gesture.end();
  De = null;
}
T(() => {
  void We.value;
  se(() => [..._n].forEach((e) => e.followed()));
});
T(() => {
  if (Q.value !== "open") [..._n].forEach((e) => e.drop());
});

// src/before.ts
var co = v(null);
var we = v(null);
var tc = v(0.5);
function il() {
  const e = te.peek();
  const t = Gi();
  if (e && t) co.value = { picture: t, camera: e.camera };
}
Ji(() => {
  if (we.peek() !== "wipe") il();
});
function Zi() {
  const e = co.peek();
  const t = te.peek();
  if (!e || !t) G("Nothing has been changed yet.");
  else if (!dn(e.camera, t.camera)) G("The picture before was taken from another place: go back there with Alt+←.", "warn");
  else return true;
  return false;
}
function Wt(e) {
  if (!e) {
    if (we.peek() === "held") we.value = null;
  } else if (we.peek() === null && Zi()) we.value = "held";
}
function ea() {
  we.value = we.peek() === "wipe" ? null : Zi() ? "wipe" : null;
}

// src/select.ts
var M = v(null);
var ie = v(null);
var U = v(null);
var fr = v("move");
var F = Y(() => {
  const e = M.value;
  if (e?.kind === "lamp") return e.ids.filter((t) => y.get(t));
  if (e?.kind === "group") return e.ids.flatMap((t) => K.get(t)?.lamps ?? []);
  return [];
});
function de(e, t, n = "only") {
  const o = M.peek();
  if (n === "only" || o?.kind !== e) {
    M.value = { kind: e, ids: [t] };
    return;
  }
  const r = o.ids.includes(t);
  if (r && n === "add") return;
  const i = r ? o.ids.filter((s) => s !== t) : [...o.ids, t];
  M.value = i.length ? { kind: e, ids: i } : null;
}
function kn() {
  M.value = null;
}
function ta(e, t, n) {
  const o = M.peek();
  const r = o?.kind === e ? t.indexOf(o.ids[o.ids.length - 1]) : -1;
  if (r < 0) return de(e, n);
  const i = t.indexOf(n);
  const [s, l] = r < i ? [r, i] : [i, r];
  const d = t.slice(s, l + 1);
  const u = (o?.ids ?? []).filter((c) => !d.includes(c));
  M.value = { kind: e, ids: [...u, ...r < i ? d : d.reverse()] };
}
function mr(e) {
  const t = M.peek();
  const n = t?.kind ?? "lamp";
  const o = n === "lamp" ? y.ids.peek() : n === "thing" ? pe.ids.peek() : K.ids.peek();
  if (!o.length) return;
  const r = t ? o.indexOf(t.ids[t.ids.length - 1]) : e > 0 ? -1 : 0;
  de(n, o[(r + e + o.length) % o.length]);
}
function al(e, t) {
  switch (e) {
    case "lamp":
      return y.get(t)?.name ?? `lamp ${t}`;
    case "group":
      return K.get(t)?.name ?? `group ${t}`;
    case "thing":
      return pe.get(t)?.name ?? `thing ${t}`;
    case "material":
      return vn.get(t)?.name ?? `material ${t}`;
    default:
      return `${e} ${t}`;
  }
}
function Pe(e) {
  return e.length === 1 ? al("lamp", e[0]) : `${e.length} lamps`;
}
function na(e, t) {
  const n = [];
  if (e?.lamp != null) {
    n.push({ kind: "lamp", ids: [e.lamp] });
    const i = y.get(e.lamp)?.group;
    if (i != null && (K.get(i)?.lamps.length ?? 0) > 1) n.push({ kind: "group", ids: [i] });
  }
  if (e?.thing != null) n.push({ kind: "thing", ids: [e.thing] });
  if (!n.length) {
    if (t === "only") kn();
    return;
  }
  if (t !== "only") return de(n[0].kind, n[0].ids[0], t);
  const o = M.peek();
  const r = n.findIndex((i) => o?.kind === i.kind && o.ids.length === 1 && o.ids[0] === i.ids[0]);
  M.value = n[(r + 1) % n.length];
}
var Ge = v(null);

// src/highlight.ts
function po(e) {
  Ee.value = e;
  q({ do: "solo", lamps: e });
}
function hr(e) {
  const t = Ee.peek();
  const n = e.every((o) => t.includes(o));
  po(n ? t.filter((o) => !e.includes(o)) : [...t, ...e.filter((o) => !t.includes(o))]);
}
var oa = () => hr(F.peek());
var fo = () => po([]);
var wn = null;
function xn(e) {
  if (e && wn === null && F.peek().length) {
    wn = Ee.peek();
    po(F.peek());
  } else if (!e && wn !== null) {
    po(wn);
    wn = null;
  }
}

// src/prefs.ts
var ra = "lampyris-";
function fe(e, t) {
  let n = t;
  try {
    const r = localStorage.getItem(ra + e);
    if (r !== null) n = JSON.parse(r);
  } catch {
  }
  const o = v(n);
  T(() => {
    const r = JSON.stringify(o.value);
    try {
      localStorage.setItem(ra + e, r);
    } catch {
    }
  });
  return o;
}
var ct = fe("theme", "dark");
var Bt = fe("house-lights", 1);
var Sn = fe("hands", "default");
var pt = fe("walking", "walk");
var Mn = fe("panels", true);
var dt = fe("listing", "faders");
var zt = fe("travel", "square");
var ft = fe("candles", "lx");
var ia = fe("single-keys", true);
var Cn = fe("lamp-marks", true);
var mo = fe("maintenance", 1);
var Oe = fe("fine", false);
var $t = fe("fade", 1);
var sl = typeof matchMedia === "function" && matchMedia("(pointer: coarse)").matches;
var xe = fe("look-only", sl);

// src/navigate.ts
var ll = 1.6;
var Se = v(null);
var Xe = Y(() => z.value?.up ?? [0, 0, 1]);
var Le = v([640, 480]);
var Et = v(null);
var gr = null;
var En = null;
var vr = false;
var mt = [];
var yr = [];
var br = 0;
function j(e, t = null) {
  const n = Se.peek();
  if (n && dn(n, e)) return;
  const o = performance.now();
  if (n && (o - br > 1e3 || t)) {
    mt.push(n);
    if (mt.length > 100) mt.shift();
    yr.length = 0;
  }
  br = o;
  Se.value = e;
  Et.value = t;
}
var ae = () => Se.peek();
function sa() {
  ua(mt, yr);
}
function la() {
  ua(yr, mt);
}
function ua(e, t) {
  const n = e.pop();
  if (!n) return;
  const o = Se.peek();
  if (o) t.push(o);
  br = performance.now();
  Se.value = n;
  Et.value = null;
}
T(() => {
  const e = Se.value;
  if (!e || Q.value !== "open" || _e.value === "watch" || vr) return;
  vr = true;
  requestAnimationFrame(() => {
    vr = false;
    const t = Se.peek();
    if (!t || En && dn(En, t)) return;
    const { eye: n, target: o, up: r, fov: i, height: s, near: l } = t;
    const d = { do: "camera", eye: n, target: o, up: r, fov: i };
    if (s) d.height = s;
    if (l) d.near = l;
    if (q(d)) En = t;
  });
});
T(() => {
  const e = te.value;
  if (!e) return;
  se(() => {
    if (Se.peek() && _e.peek() === "edit") return;
    En = e.camera;
    Se.value = e.camera;
    gr ??= e.camera;
  });
});
Ae("hello", () => En = null);
function Gt(e, t) {
  const n = te.peek();
  if (!n) return null;
  const { head: o } = n;
  const r = ho(o.width, o.height);
  return { frame: o.frame, x: (e - r.x) / r.scale, y: (t - r.y) / r.scale };
}
function ho(e, t) {
  const [n, o] = Le.peek();
  const r = Math.min(n / e, o / t);
  return { x: (n - e * r) / 2, y: (o - t * r) / 2, scale: r };
}
function Tt(e = Se.peek()) {
  const [t, n] = Le.peek();
  return e ? pn(e, t, n) : null;
}
var Tn = () => z.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]];
var Xt = () => wt(Tn());
function vo(e, t) {
  const n = ae();
  if (n) j(Mi(n, Xe.peek(), e, t));
}
function go(e, t, n) {
  const o = ae();
  if (o) j(Ei(o, Xe.peek(), e, t, n));
}
function Yt(e, t, n) {
  const o = ae();
  const r = Tt();
  if (o && r) j(Ti(o, r, e, t, n));
}
function ca(e, t, n) {
  const o = ae();
  if (!o) return;
  if (o.height) {
    const r = Tt(o);
    if (r) j(at(o, C(x(r.side, t), x(r.up, e))));
    return;
  }
  if (pt.peek() === "fly" || n !== 0) j($i(o, Xe.peek(), e, t, n));
  else {
    j(Ci(o, Xe.peek(), e, t, 0));
    ul();
  }
}
var $n = false;
var aa = null;
function ul() {
  const e = ae();
  if (!e || $n) return;
  const t = Xe.peek();
  $n = true;
  const n = ke("ray", { origin: e.eye, direction: x(t, -1) }, (o) => {
    $n = false;
    const r = ae();
    if (!o.hit || !r || r.height) return;
    aa = W(o.point, t);
    const i = aa + ll - W(r.eye, t);
    if (Math.abs(i) > 0.01) j(at(r, x(t, i * 0.5)));
  });
  setTimeout(() => {
    if ($n) n();
    $n = false;
  }, 500);
}
function cl() {
  const e = M.peek();
  if (!e) return null;
  const t = [];
  const n = (i, s) => {
    if (i) t.push(i);
    else if (s) t.push([s, s]);
  };
  for (const i of e.ids) {
    if (e.kind === "lamp") n(y.get(i)?.box, y.get(i)?.place?.position);
    if (e.kind === "thing") n(pe.get(i)?.box);
    if (e.kind === "meter") n(null, ve.get(i)?.point);
    if (e.kind === "group") {
      for (const s of K.get(i)?.lamps ?? []) n(y.get(s)?.box, y.get(s)?.place?.position);
    }
  }
  if (!t.length) return null;
  const o = t.flatMap(cn);
  const r = (i) => [0, 1, 2].map((s) => i(...o.map((l) => l[s])));
  return [r(Math.min), r(Math.max)];
}
function bo() {
  const e = ae();
  const t = cl();
  if (e && t) j(Pi(e, t), "selection");
  else yo();
}
function yo() {
  if (gr) j(gr, "home");
}
function pa(e) {
  const [t, n] = Le.peek();
  j(Vi(e, Tn(), Xe.peek(), t / n), e);
}
function da() {
  for (let e = mt.length - 1; e >= 0; e--) {
    if (!mt[e].height) return j(mt[e], "inside");
  }
  yo();
}
var fa = Y(() => {
  const e = Se.value;
  if (!e?.height) return null;
  const t = pn(e, 2, 2);
  const n = cn(Tn()).map((o) => W(H(o, e.eye), t.forward));
  return { value: e.near ?? 0, most: Math.max(...n) };
});
function ma(e) {
  const t = ae();
  if (t) Se.value = { ...t, near: Math.max(0, e) };
}

// src/tools.ts
var Ln = v("spot");
var Pn = null;
function Ye(e) {
  Pn = null;
  U.value = U.peek() === e ? null : e;
}
function va(e) {
  if (!e) return G("There is nothing at that point.", "warn");
  switch (U.peek()) {
    case "aim":
      _r(F.peek(), e.point);
      U.value = null;
      break;
    case "meter":
      wr(e.point, e.normal);
      U.value = null;
      break;
    case "grid":
      if (!Pn) {
        Pn = e;
        return;
      }
      dl(Pn.point, e.point);
      Pn = null;
      U.value = null;
      break;
    case "add":
      fl(Ln.peek(), e);
      U.value = null;
      break;
  }
}
function _r(e, t) {
  const n = {};
  for (const o of e) {
    const r = y.get(o)?.place;
    if (!r?.position || !r.direction) continue;
    n[o] = { place: { aim: t, direction: J(H(t, r.position)) } };
  }
  if (!Object.keys(n).length) return G("What is selected shines into all directions: it cannot be aimed.", "warn");
  oe(`Aim ${Pe(e)}`, { lamps: n });
}
function kr(e, t) {
  const n = new Set(e.ids.peek());
  const o = e.ids.subscribe((r) => {
    const i = r.filter((s) => !n.has(s));
    if (!i.length) return;
    de(t, i[i.length - 1]);
    queueMicrotask(() => o());
  });
  setTimeout(() => o(), 3e3);
}
var Vn = (e) => Math.max(-1, ...e.ids.peek()) + 1;
function wr(e, t) {
  const n = Vn(ve);
  kr(ve, "meter");
  oe("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function pl(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
function dl(e, t, n = { lux: 500, uniformity: 0.6 }) {
  const o = Xe.peek();
  const r = Math.abs(o[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
  const i = J(he(o, r));
  const s = H(t, e);
  let [l, d] = [W(s, r), W(s, i)];
  if (Math.abs(l) < 0.05 || Math.abs(d) < 0.05) return G("An area needs two corners that lie apart.", "warn");
  const u = C(e, C(x(r, Math.min(l, 0)), x(i, Math.min(d, 0))));
  [l, d] = [Math.abs(l), Math.abs(d)];
  const c = (m) => Math.max(1, Math.ceil(m / pl(Math.max(l, d))));
  const f = Vn($e);
  kr($e, "grid");
  oe("Lay a grid", {
    grids: {
      [f]: {
        name: `Area ${f + 1}`,
        corner: u,
        u: x(r, l),
        v: x(i, d),
        normal: o,
        columns: c(l),
        rows: c(d),
        target: n
      }
    }
  });
}
var ha = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function fl(e, t) {
  const n = Xe.peek();
  const o = W(t.normal, n);
  const r = o > 0.7 ? C(t.point, x(n, 1.2)) : C(t.point, x(t.normal, 0.15));
  const i = o > 0.7 || o < -0.7 ? x(n, -1) : t.normal;
  const s = { position: r };
  if (e !== "point" && e !== "sphere") s.direction = i;
  if (e === "spot") Object.assign(s, { inner: 24, outer: 36, aim: o > 0.7 ? t.point : null });
  if (e === "disc") s.radius = 0.15;
  if (e === "sphere") s.radius = 0.08;
  const l = y.all().filter(([, d]) => d.own).length;
  kr(y, "lamp");
  uo(`Add ${ha[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: {
      name: `${ha[e] ?? e} ${l + 1}`,
      kind: e,
      on: true,
      level: 1,
      flux: 800,
      color: { mode: "kelvin", kelvin: 3e3, tint: 0, rgb: [1, 1, 1], xy: [0.4369, 0.4041] },
      place: s
    }
  });
}
function ga(e, t, n) {
  if (!e.length || t < 1) return;
  uo(`Copy ${Pe(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function ba(e) {
  if (e.length) uo(`Remove ${Pe(e)}`, { do: "remove", lamps: e });
}
function ml(e, t, n) {
  const o = {};
  for (const r of e) {
    const i = y.get(r)?.place;
    const s = n.get(r);
    if (!i || !s) continue;
    const l = C(s, t);
    const d = i.aim && Ue(i.aim, l) > 1e-6 ? { direction: J(H(i.aim, l)) } : {};
    o[r] = { place: { position: l, ...d } };
  }
  return { lamps: o };
}
function hl(e) {
  const t = /* @__PURE__ */ new Map();
  for (const n of e) {
    const o = y.get(n)?.place?.position;
    if (o) t.set(n, o);
  }
  return t;
}
function Ec(e, t) {
  const n = new Be(`Move ${Pe(e)}`);
  n.set(ml(e, t, hl(e)));
  n.end();
}

// src/actions.ts
var Ve = v(null);
var vt = v("lamps");
var _a = v("");
var ht = () => ue() ?? (F.value.length ? null : "Select a lamp first.");
function Ke(e) {
  const t = ue();
  if (t) G(t, "warn");
  else q(e);
}
function vl() {
  const e = F.peek();
  const t = !e.some((n) => y.get(n)?.on);
  oe(`${Pe(e)} ${t ? "on" : "off"}`, { lamps: Sr(e, { on: t }) });
}
var Sr = (e, t) => Object.fromEntries(e.map((n) => [n, t]));
function gl() {
  const e = F.peek();
  const t = !e.every((n) => y.get(n)?.parked);
  oe(`${t ? "Park" : "Unpark"} ${Pe(e)}`, { lamps: Sr(e, { parked: t }) });
}
var bl = {
  quantity: "illuminance",
  low: 1,
  high: 1e3,
  scale: "log",
  palette: "viridis",
  lines: false
};
var xr = bl;
function Mr() {
  const e = St.peek().false_color;
  if (e) xr = e;
  ze({ false_color: e ? null : xr });
}
function In(e) {
  const t = Math.round((St.peek().ev + e / 3) * 30) / 30;
  ze({ ev: t });
}
function ya(e) {
  const t = M.peek();
  const n = e ? t?.kind === "thing" ? t.ids : [] : pe.ids.peek().filter((o) => pe.get(o)?.hidden);
  if (!n.length) return G(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  oe(e ? "Hide things" : "Show hidden things", { things: Sr(n, { hidden: e }) });
}
function Cr() {
  const e = ae();
  if (!e) return;
  const t = Vn(st);
  oe("Store the view", { views: { [t]: { ...e, name: `View ${t + 1}` } } });
}
var $r = () => Ke({ do: "look", what: "store", name: `Look ${Vn(lt) + 1}` });
function yl() {
  const e = F.peek()[0];
  const t = y.get(e)?.place;
  const n = ae();
  if (!t?.position || !t.direction || !n) return G("Select a lamp that has a direction.", "warn");
  const { position: o, direction: r } = t;
  j({ ...n, eye: o, target: [o[0] + r[0], o[1] + r[1], o[2] + r[2]], height: null, near: null }, "from the lamp");
}
function _l() {
  ke("command", {}, (e) => void Er(e.text));
}
async function Er(e) {
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
  G(t ? "Copied." : `Copy it by hand: ${e}`);
}
var kl = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]];
var wl = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
};
var Rn = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: bo },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: yo },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: da },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: sa },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: la },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Cr, why: ue },
  ...Li.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: wl[e],
    keys: `Shift+${t + 1}`,
    run: () => pa(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      pt.value = pt.peek() === "walk" ? "fly" : "walk";
      G(pt.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: yl, why: ht },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => mr(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => mr(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => Ye("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => M.value = { kind: "lamp", ids: y.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: kn },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: vl, why: ht },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: oa, why: () => F.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: fo },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => xn(true), why: ht },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: gl, why: ht },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => Ye("aim"), why: ht },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => Ge.peek() && _r(F.peek(), Ge.peek().point), why: ht },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => fr.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => fr.value = "turn" },
  ...kl.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: ue,
    run: () => {
      Ln.value = e;
      Ye("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => ga(F.peek(), 1, [0.5, 0, 0]), why: ht },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => ba(F.peek()), why: ht },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => ya(true), why: ue },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => ya(false), why: ue },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => Ke({ do: "undo" }), why: () => ue() ?? (je.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => Ke({ do: "redo" }), why: () => ue() ?? (je.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => Ve.value = "save", why: ue },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => Ve.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: _l },
  { id: "share", group: "Work", label: "Share by link", run: () => Ve.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: Mr },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      const e = St.peek().false_color ?? xr;
      ze({ false_color: { ...e, quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => In(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => In(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => q({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => Wt(true) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: ea },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: ue, run: () => Ge.peek() ? wr(Ge.peek().point, Ge.peek().normal) : Ye("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => Ye("meter"), why: ue },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => Ye("grid"), why: ue },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => ft.value = ft.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: $r, why: ue },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => G("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => Mn.value = !Mn.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => dt.value = dt.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => zt.value = zt.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => Cn.value = !Cn.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => Oe.value = !Oe.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => ct.value = ct.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => xe.value = !xe.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => Sn.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => Ve.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => Ve.value = "palette" }
];
var Tr = new Map(Rn.map((e) => [e.id, e]));
function B(e) {
  const t = Tr.get(e);
  const n = t?.why?.();
  if (n) G(n, "warn");
  else t?.run();
}
function ka(e) {
  return Tr.get(e)?.why?.() ?? null;
}
var wa = (e) => Tr.get(e)?.keys;
function xa() {
  const e = (z.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t }));
  return [...e, ...st.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/units.ts
var _o = 0.3048;
var Sa = {
  level: { bare: 0.01, units: { "%": 0.01, x: 1, "×": 1 }, low: 0, high: 1e3, say: "a level such as 80 % or 450 lm" },
  flux: { bare: 1, units: { lm: 1, klm: 1e3 }, low: 0, high: 1e9, say: "a flux such as 450 lm" },
  kelvin: { bare: 1, units: { k: 1 }, low: 1e3, high: 25e3, say: "a colour temperature such as 2700 K" },
  angle: { bare: 1, units: { "°": 1, deg: 1, rad: 180 / Math.PI }, low: -36e3, high: 36e3, say: "an angle such as 30°" },
  length: {
    bare: 1,
    units: { m: 1, cm: 0.01, mm: 1e-3, km: 1e3, ft: _o, "'": _o, in: _o / 12, '"': _o / 12 },
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
var xl = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;
function Pr(e) {
  const t = xl.exec(e);
  if (!t) return null;
  const [n, o] = t[0].split("/").map(Number);
  if (o === 0) return null;
  return { value: o === void 0 ? n : n / o, rest: e.slice(t[0].length).trimStart() };
}
function Ma(e, t, n) {
  let o = e.trim();
  let r = 0;
  let i = true;
  while (o) {
    let s = 1;
    const l = /^[+-]\s*/.exec(o);
    if (l && !i) {
      s = o[0] === "-" ? -1 : 1;
      o = o.slice(l[0].length);
    }
    const d = Pr(o);
    if (!d) return null;
    const u = /^[a-zµ°%'"×]+/i.exec(d.rest)?.[0] ?? "";
    const c = u === "" ? n : t.units[u.toLowerCase()];
    if (c === void 0) return null;
    r += s * d.value * c;
    o = d.rest.slice(u.length).trim();
    i = false;
  }
  return i ? null : r;
}
function Ca(e, t, n) {
  const o = Sa[t];
  const r = e.trim().replace(/,(?=\d)/g, ".").replace(/[\u2009\u202f\u00a0]/g, "").replace(/−/g, "-");
  const i = { why: `“${e.trim()}” is not ${o.say}` };
  const s = (w) => ({
    apply: (S) => Math.min(o.high, Math.max(o.low, w(S)))
  });
  if (!r) return { why: `Type ${o.say}` };
  const l = r.toLowerCase();
  if (t === "level" && l === "full") return s(() => 1);
  if (t === "level" && (l === "out" || l === "off")) return s(() => 0);
  const d = /^(.*?)\s*(?:stops?|ev)$/i.exec(r);
  if (d && t !== "ev") {
    const w = Pr(d[1].trim());
    if (!w || w.rest || !["level", "flux", "lux", "number"].includes(t)) return i;
    return s((S) => S * 2 ** w.value);
  }
  const u = /^([*/×÷])\s*(.+)$/.exec(r);
  if (u) {
    const w = Pr(u[2]);
    if (!w) return i;
    const S = w.rest === "%" ? 0.01 : w.rest === "" ? 1 : NaN;
    const k = w.value * S;
    if (!Number.isFinite(k) || k === 0 && /[/÷]/.test(u[1])) return i;
    return s((b) => /[/÷]/.test(u[1]) ? b / k : b * k);
  }
  const c = t === "length" || t === "angle" || t === "ev" || t === "number";
  const f = c ? /^([+-])=\s*(.+)$/.exec(r) : /^([+-])=?\s*(.+)$/.exec(r);
  const m = f ? f[2] : r;
  let p = Ma(m, o, o.bare);
  if (p === null && t === "level" && n) {
    const w = Ma(m, { ...Sa.flux }, NaN);
    p = w === null || Number.isNaN(w) ? null : w / n;
  }
  if (p === null || !Number.isFinite(p)) return i;
  const _ = p;
  if (f) return s((w) => f[1] === "-" ? w - _ : w + _);
  if (_ < o.low || _ > o.high) {
    return { why: `${e.trim()} is out of range: ${o.say}` };
  }
  return s(() => _);
}
function R(e, t = 0) {
  if (!Number.isFinite(e)) return "–";
  const [n, o] = Math.abs(e).toFixed(t).split(".");
  const r = n.length > 4 ? n.replace(/\B(?=(\d{3})+$)/g, " ") : n;
  const i = e < 0 && Number(Math.abs(e).toFixed(t)) !== 0 ? "−" : "";
  return i + r + (o ? `.${o}` : "");
}
function Je(e) {
  const t = Math.abs(e);
  return R(e, t >= 99.95 || t === 0 ? 0 : t >= 9.995 ? 1 : t >= 0.9995 ? 2 : 3);
}
function Qe(e) {
  const t = e * 100;
  return R(t, t >= 9.95 || t === 0 ? 0 : t >= 0.95 ? 1 : 2);
}
function ko(e, t) {
  switch (t) {
    case "level":
      return `${Qe(e)} %`;
    case "flux":
      return `${Je(e)} lm`;
    case "kelvin":
      return `${R(e)} K`;
    case "angle":
      return `${R(e, 1)}°`;
    case "length":
      return `${R(e, 2)} m`;
    case "lux":
      return `${Je(e)} lx`;
    case "seconds":
      return `${R(e, 1)} s`;
    case "ev":
      return R(e, 1);
    case "share":
      return R(e, 2);
    case "number":
      return String(Math.round(e * 1e4) / 1e4);
  }
}
function be(e, t = true) {
  const n = ft.value === "fc";
  const o = n ? e / 10.7639 : e;
  return Je(o) + (t ? n ? " fc" : " lx" : "");
}

// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var Sl = /* @__PURE__ */ Symbol.for("pv");
var Ml = 0;
function a(e, t, n, o, r, i) {
  t || (t = {});
  var s, l, d = t;
  if ("ref" in d && "function" != typeof e) for (l in d = {}, t) "ref" == l ? s = t[l] : d[l] = t[l];
  var u = { type: e, props: d, key: n, ref: s, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: Sl, __v: --Ml, __i: -1, __u: 0 };
  return (r || i) && (u.__source = r, u.__self = i), $.vnode && $.vnode(u), u;
}

// src/field.tsx
function Fe(e) {
  const t = rt(null);
  const n = rt(null);
  const o = ee(null);
  const r = ee(null);
  const i = t.value ?? e.text ?? (e.value === null ? "mixed" : ko(e.value, e.quantity));
  Ie(() => {
    if (!e.open || !o.current) return;
    t.value = e.open;
    o.current.focus();
    o.current.setSelectionRange(e.open.length, e.open.length);
    e.opened?.();
  }, [e.open]);
  const s = () => {
    if (t.value === null) return;
    const f = Ca(t.value, e.quantity, e.flux);
    if ("why" in f) {
      n.value = f.why;
      return;
    }
    t.value = null;
    n.value = null;
    e.set(f.apply);
  };
  const l = (f) => {
    if (f.key === "Enter") {
      f.preventDefault();
      s();
      if (t.value === null) o.current?.select();
    } else if (f.key === "Escape") {
      f.stopPropagation();
      if (t.value === null) o.current?.blur();
      t.value = null;
      n.value = null;
    } else if ((f.key === "ArrowUp" || f.key === "ArrowDown") && e.step && t.value === null) {
      f.preventDefault();
      const m = (f.key === "ArrowUp" ? 1 : -1) * e.step * (f.shiftKey ? 10 : f.ctrlKey ? 0.1 : 1);
      e.set((p) => p + m);
    }
  };
  const d = (f) => {
    if (!e.scrub || e.disabled || f.button !== 0 || document.activeElement === o.current) return;
    r.current = { x: f.clientX, last: f.clientX, moved: false };
    o.current?.setPointerCapture(f.pointerId);
    f.preventDefault();
  };
  const u = (f) => {
    const m = r.current;
    if (!m || !e.scrub) return;
    if (!m.moved && Math.abs(f.clientX - m.x) < 4) return;
    if (!m.moved) e.scrub.begin();
    m.moved = true;
    e.scrub.on((f.clientX - m.last) * (e.step ?? 1) * (f.shiftKey ? 0.1 : f.altKey ? 10 : 1));
    m.last = f.clientX;
  };
  const c = (f) => {
    const m = r.current;
    r.current = null;
    if (!m) return;
    if (!m.moved) {
      o.current?.focus();
      o.current?.select();
    } else if (f.type === "pointercancel") e.scrub?.cancel();
    else e.scrub?.end();
  };
  return /* @__PURE__ */ a("span", { class: `field ${n.value ? "wrong" : ""} ${e.scrub ? "scrubs" : ""}`, children: [
    /* @__PURE__ */ a(
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
        onInput: (f) => {
          t.value = f.currentTarget.value;
          n.value = null;
        },
        onFocus: (f) => t.value === null && f.currentTarget.select(),
        onBlur: () => {
          s();
          if (n.value) {
            t.value = null;
            setTimeout(() => n.value = null, 4e3);
          }
        },
        onKeyDown: l,
        onPointerDown: d,
        onPointerMove: u,
        onPointerUp: c,
        onPointerCancel: c
      }
    ),
    n.value && /* @__PURE__ */ a("span", { class: "why", role: "alert", id: `${e.id ?? e.label}-why`.replace(/\s/g, "-"), children: n.value })
  ] });
}

// src/icon.tsx
function E({ name: e }) {
  return /* @__PURE__ */ a("svg", { class: "sign", "aria-hidden": "true", width: "16", height: "16", children: /* @__PURE__ */ a("use", { href: `icons.svg#${e}` }) });
}

// src/menu.tsx
function Jt({ id: e, label: t, title: n, children: o }) {
  const r = (s) => {
    const l = document.getElementById(e);
    const d = s.getBoundingClientRect();
    l?.style.setProperty("left", `${Math.max(8, Math.min(d.left, innerWidth - 296))}px`);
    l?.style.setProperty("top", `${d.bottom + 4}px`);
  };
  const i = { popovertarget: e };
  return /* @__PURE__ */ a(X, { children: [
    /* @__PURE__ */ a("button", { ...i, title: n, "aria-label": n, "aria-haspopup": "true", onPointerDown: (s) => r(s.currentTarget), onFocus: (s) => r(s.currentTarget), children: t }),
    /* @__PURE__ */ a("div", { id: e, popover: "auto", class: "menu", children: o })
  ] });
}
function Ne({ id: e, label: t }) {
  const n = ka(e);
  const o = Rn.find((r) => r.id === e);
  return /* @__PURE__ */ a(
    "button",
    {
      class: "item",
      "aria-disabled": n !== null,
      title: n ?? void 0,
      onClick: (r) => {
        r.currentTarget.closest("[popover]")?.hidePopover();
        B(e);
      },
      children: [
        /* @__PURE__ */ a("span", { children: t ?? o?.label }),
        /* @__PURE__ */ a("kbd", { children: wa(e) })
      ]
    }
  );
}

// src/range.tsx
var $a = -1e9;
addEventListener("scroll", () => $a = performance.now(), { capture: true, passive: true });
var Qt = (e) => Math.max(0, Math.min(1, e));
function Zt(e) {
  const t = ee(null);
  const n = ee(null);
  const o = e.notch ?? 0.01;
  const r = (u) => {
    if (u.button !== 0 || e.disabled) return;
    const c = u.currentTarget.getBoundingClientRect();
    const f = e.vertical ? (c.bottom - u.clientY - 8) / (c.height - 16) : (u.clientX - c.left - 6) / (c.width - 12);
    const m = u.pointerType !== "touch" && !u.shiftKey;
    n.current = { id: u.pointerId, x: u.clientX, y: u.clientY, at: m ? Qt(f) : e.value };
    t.current?.setPointerCapture(u.pointerId);
    t.current?.focus();
    e.begin?.();
    if (m) e.on(Qt(f));
  };
  const i = (u) => {
    const c = n.current;
    if (!c || c.id !== u.pointerId) return;
    const f = u.currentTarget.getBoundingClientRect();
    const m = e.vertical ? (c.y - u.clientY) / (f.height - 16) : (u.clientX - c.x) / (f.width - 12);
    c.x = u.clientX;
    c.y = u.clientY;
    c.at += m * (u.shiftKey ? 0.1 : 1);
    e.on(Qt(c.at));
  };
  const s = (u) => {
    if (n.current?.id !== u.pointerId) return;
    n.current = null;
    if (u.type === "pointercancel") e.cancel?.();
    else e.end?.();
  };
  const l = (u) => {
    if (u.key === "Escape" && n.current) {
      n.current = null;
      e.cancel?.();
      u.stopPropagation();
      return;
    }
    const c = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[u.key];
    let f = null;
    if (c) f = Qt(e.value + c * o * (u.shiftKey ? 10 : 1));
    if (u.key === "Home") f = 0;
    if (u.key === "End") f = 1;
    if (f === null || u.altKey || u.ctrlKey || u.metaKey) return;
    u.preventDefault();
    u.stopPropagation();
    e.on(f);
  };
  const d = (u) => {
    if (performance.now() - $a < 400 || u.ctrlKey) return;
    u.preventDefault();
    const c = Math.abs(u.deltaY) >= Math.abs(u.deltaX) ? u.deltaY : u.deltaX;
    if (c) e.on(Qt(e.value - Math.sign(c) * o * (u.shiftKey ? 0.2 : 1)));
  };
  return /* @__PURE__ */ a(
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
      style: { "--t": Qt(e.value) },
      onPointerDown: r,
      onPointerMove: i,
      onPointerUp: s,
      onPointerCancel: s,
      onMouseDown: (u) => u.preventDefault(),
      onTouchStart: (u) => u.cancelable && u.preventDefault(),
      onKeyDown: l,
      onWheel: d,
      onDblClick: () => e.reset?.(),
      onInput: (u) => {
        if (!n.current) e.on(Number(u.currentTarget.value));
        else u.currentTarget.value = String(e.value);
      }
    }
  );
}

// src/bar.tsx
function Cl() {
  const e = xa();
  return /* @__PURE__ */ a(Jt, { id: "view-menu", label: /* @__PURE__ */ a(X, { children: [
    "View ",
    /* @__PURE__ */ a(E, { name: "down" })
  ] }), title: "View", children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((t) => /* @__PURE__ */ a(Ne, { id: t }, t)),
    /* @__PURE__ */ a("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((t) => /* @__PURE__ */ a(Ne, { id: `preset-${t}` }, t)),
    /* @__PURE__ */ a("hr", {}),
    e.length > 0 && /* @__PURE__ */ a("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    e.map(({ name: t, camera: n }, o) => /* @__PURE__ */ a("button", { class: "item", onClick: () => j(n, t), children: /* @__PURE__ */ a("span", { children: t }) }, o)),
    e.length > 0 && /* @__PURE__ */ a("hr", {}),
    /* @__PURE__ */ a(Ne, { id: "walking", label: pt.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    /* @__PURE__ */ a(Ne, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((t) => /* @__PURE__ */ a(Ne, { id: `hands-${t}` }, t))
  ] });
}
var $l = ["linear", "reinhard", "filmic"];
function El() {
  const e = St.value;
  return /* @__PURE__ */ a(Jt, { id: "seeing-menu", label: /* @__PURE__ */ a(X, { children: [
    "Picture ",
    /* @__PURE__ */ a(E, { name: "down" })
  ] }), title: "Tone and white", children: [
    /* @__PURE__ */ a("fieldset", { children: [
      /* @__PURE__ */ a("legend", { children: "Tone curve" }),
      /* @__PURE__ */ a("div", { class: "segments", children: $l.map((t) => /* @__PURE__ */ a("button", { "aria-pressed": e.tone === t, onClick: () => ze({ tone: t }), children: t }, t)) })
    ] }),
    /* @__PURE__ */ a("fieldset", { children: [
      /* @__PURE__ */ a("legend", { children: "White balance" }),
      /* @__PURE__ */ a("label", { class: "line", children: [
        /* @__PURE__ */ a("span", { children: "White" }),
        /* @__PURE__ */ a(Fe, { label: "White", quantity: "kelvin", value: e.white.kelvin, step: 100, set: (t) => ze({ white: { ...e.white, kelvin: t(e.white.kelvin) } }) })
      ] }),
      /* @__PURE__ */ a("label", { class: "line", children: [
        /* @__PURE__ */ a("span", { children: "Tint" }),
        /* @__PURE__ */ a(Fe, { label: "Tint of white", quantity: "number", value: e.white.tint, step: 1, set: (t) => ze({ white: { ...e.white, tint: t(e.white.tint) } }) })
      ] })
    ] }),
    /* @__PURE__ */ a("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((t) => /* @__PURE__ */ a(Ne, { id: t }, t))
  ] });
}
function Tl() {
  return /* @__PURE__ */ a(Jt, { id: "page-menu", label: /* @__PURE__ */ a(E, { name: "menu" }), title: "Page", children: [
    /* @__PURE__ */ a("label", { class: "line", children: [
      /* @__PURE__ */ a("span", { children: "House lights" }),
      /* @__PURE__ */ a(Zt, { label: "House lights", value: Bt.value, text: `${R(Bt.value * 100)} %`, on: (e) => Bt.value = Math.max(0.3, e) })
    ] }),
    /* @__PURE__ */ a("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => /* @__PURE__ */ a("button", { "aria-pressed": ct.value === e, onClick: () => ct.value = e, children: e }, e)) }),
    /* @__PURE__ */ a("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => /* @__PURE__ */ a(Ne, { id: e }, e))
  ] });
}
var Ea = {
  clean: "nothing changed",
  saved: "saved",
  waiting: "saving…",
  failed: "not saved"
};
function Ta() {
  const e = St.value;
  const t = je.value.undo;
  const n = je.value.redo;
  const o = xt.value;
  const r = e.metered !== null && Math.abs(e.ev - e.metered) < 5e-3;
  return /* @__PURE__ */ a("header", { class: "bar", children: [
    /* @__PURE__ */ a(Tl, {}),
    /* @__PURE__ */ a("h1", { title: o.file || z.value?.file, children: [
      z.value?.name ?? "Lampyris",
      /* @__PURE__ */ a("i", { class: `dot ${o.state}`, role: "img", "aria-label": Ea[o.state], title: `${Ea[o.state]}${o.file ? `: ${o.file}` : ""}` })
    ] }),
    /* @__PURE__ */ a("span", { class: "group", children: [
      /* @__PURE__ */ a("button", { class: "icon", "aria-label": t ? `Undo: ${t}` : "Undo", title: t ? `Undo: ${t} (Ctrl+Z)` : "Nothing to undo", "aria-disabled": t === null, onClick: () => B("undo"), children: /* @__PURE__ */ a(E, { name: "undo" }) }),
      /* @__PURE__ */ a("button", { class: "icon", "aria-label": n ? `Redo: ${n}` : "Redo", title: n ? `Redo: ${n} (Ctrl+Shift+Z)` : "Nothing to redo", "aria-disabled": n === null, onClick: () => B("redo"), children: /* @__PURE__ */ a(E, { name: "redo" }) })
    ] }),
    /* @__PURE__ */ a(Cl, {}),
    /* @__PURE__ */ a("span", { class: "group wide", children: [
      /* @__PURE__ */ a("button", { "aria-pressed": false, onClick: () => B("preset-plan"), title: "Plan (Shift+1)", children: "Plan" }),
      /* @__PURE__ */ a("button", { onClick: () => B("inside"), title: "Inside (Shift+0)", children: "Inside" })
    ] }),
    /* @__PURE__ */ a("span", { class: "gap" }),
    /* @__PURE__ */ a(El, {}),
    /* @__PURE__ */ a("button", { "aria-pressed": e.false_color !== null, onClick: Mr, title: "False colour (B)", children: "False colour" }),
    /* @__PURE__ */ a("button", { "aria-pressed": we.value === "wipe", "aria-disabled": co.value === null, onClick: () => B("wipe"), title: "Wipe between before and now (C); hold \\ to see before", children: "Compare" }),
    /* @__PURE__ */ a("span", { class: "group exposure", role: "group", "aria-label": "Exposure", children: [
      /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Darker", title: "Darker by ⅓ (,)", onClick: () => In(1), children: /* @__PURE__ */ a(E, { name: "minus" }) }),
      /* @__PURE__ */ a("label", { children: [
        /* @__PURE__ */ a("span", { "aria-hidden": "true", children: "EV" }),
        /* @__PURE__ */ a(Fe, { label: "Exposure value", quantity: "ev", value: e.ev, step: 1 / 3, set: (i) => ze({ ev: i(e.ev) }) })
      ] }),
      /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Brighter", title: "Brighter by ⅓ (.)", onClick: () => In(-1), children: /* @__PURE__ */ a(E, { name: "plus" }) }),
      /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Meter once", title: `${r ? "As metered" : "Meter once"} (/); it stays locked`, onClick: () => q({ do: "expose" }), children: /* @__PURE__ */ a(E, { name: r ? "lock" : "meter" }) })
    ] }),
    /* @__PURE__ */ a(
      "button",
      {
        class: "icon look-lock",
        "aria-pressed": xe.value,
        "aria-label": "Look-only lock",
        title: "Look-only lock: no finger changes anything",
        onClick: () => xe.value = !xe.value,
        children: /* @__PURE__ */ a(E, { name: xe.value ? "lock" : "unlock" })
      }
    ),
    _e.value === "edit" && /* @__PURE__ */ a("button", { class: "wide", onClick: () => Ve.value = "share", children: "Share" }),
    /* @__PURE__ */ a("button", { class: "icon", "aria-label": "All keys", title: "All keys (?)", onClick: () => Ve.value = "help", children: /* @__PURE__ */ a(E, { name: "help" }) }),
    /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Command palette", title: "Command palette (Ctrl+K)", onClick: () => Ve.value = "palette", children: /* @__PURE__ */ a(E, { name: "search" }) }),
    /* @__PURE__ */ a(
      "button",
      {
        class: "icon narrow",
        "aria-label": vt.value === "inspector" ? "Lamps" : "Inspector",
        title: vt.value === "inspector" ? "Lamps" : "Inspector",
        onClick: () => vt.value = vt.value === "inspector" ? "lamps" : "inspector",
        children: /* @__PURE__ */ a(E, { name: vt.value === "inspector" ? "lamps" : "sliders" })
      }
    )
  ] });
}

// src/lights.ts
var Pt = v(null);
var Lr = () => {
};
var La = () => {
};
function wo(e, t, n) {
  Vr();
  Pt.value = { x: e, y: t, hit: n, lux: n.lux, lamps: [], done: false };
  Pa(n);
  let o = true;
  let r = 0;
  La = T(() => {
    for (const [, i] of y.all()) void Te(i);
    if (o) {
      o = false;
      return;
    }
    clearTimeout(r);
    r = window.setTimeout(() => {
      const i = se(() => Pt.value);
      if (i) Pa(i.hit);
    }, 250);
  });
}
function Pa(e) {
  Lr();
  Lr = ke("light", { point: e.point, normal: e.normal }, (t) => {
    const n = Pt.peek();
    if (!n) return;
    Pt.value = {
      ...n,
      lux: t.lux ?? n.lux,
      lamps: t.lamps ?? n.lamps,
      done: t.done !== false
    };
  });
}
function Vr() {
  Lr();
  La();
  Pt.value = null;
}

// src/keys.ts
var Pl = v("W A S D");
var Ir = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyA: [0, -1, 0],
  KeyD: [0, 1, 0],
  KeyQ: [0, 0, -1],
  KeyE: [0, 0, 1]
};
var Ll = 1.8;
var en = /* @__PURE__ */ new Set();
var xo = false;
var So = 1;
var Rr = false;
var Ar = 0;
function Oa(e) {
  const t = Math.min(0.1, Math.max(0, (e - Ar) / 1e3));
  Ar = e;
  if (!en.size) {
    Rr = false;
    return;
  }
  let [n, o, r] = [0, 0, 0];
  for (const l of en) {
    const [d, u, c] = Ir[l];
    n += d;
    o += u;
    r += c;
  }
  const i = Math.max(1, Ue(...Tn()) / 12);
  const s = Ll * t * So * Math.min(i, 6);
  if (n || o || r) ca(n * s, o * s, r * s);
  requestAnimationFrame(Oa);
}
function An(e) {
  en.add(e);
  if (Rr) return;
  Rr = true;
  Ar = performance.now();
  requestAnimationFrame(Oa);
}
var Vl = (e) => e instanceof HTMLElement && (e.isContentEditable || e.matches("input, textarea, select") && !e.matches("[type=range], [type=checkbox], [type=radio]"));
function Va() {
  const e = document.activeElement;
  return e === null || e === document.body || e.id === "view";
}
var Il = {
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
var Ia = {
  b: "quantity",
  o: "park",
  i: "unsolo",
  l: "from-lamp",
  g: "grid",
  t: "aim-here"
};
var Ra = { Comma: "darker", Period: "brighter", Slash: "expose" };
var Aa = {
  Digit1: "preset-plan",
  Digit2: "preset-ceiling",
  Digit3: "preset-north",
  Digit4: "preset-east",
  Digit5: "preset-south",
  Digit6: "preset-west",
  Digit0: "inside"
};
function Rl(e) {
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
function Al() {
  if (U.peek()) U.value = null;
  else if (Pt.peek()) Vr();
  else if (we.peek()) we.value = null;
  else if (M.peek()) kn();
  else if (document.activeElement?.id === "view") {
    const e = document.querySelector('.bar button, .bar [tabindex="0"]');
    e?.focus();
  }
}
function Ha(e) {
  const [t, n] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
  if (!t && !n) return false;
  if (e.ctrlKey || ae()?.height) Yt(-t * 24, n * 24, 3);
  else if (e.shiftKey) go(Xt(), -t * 0.05, n * 0.05);
  else vo(-t * 0.06, n * 0.06);
  return true;
}
function Da(e) {
  const t = ae();
  const n = Tt();
  if (!t || !n) return;
  if (t.height) j(no(t, n, n.width / 2, n.height / 2, e));
  else j(to(t, t.target, e, 0.3, true));
}
function Hl(e) {
  if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
  const t = e.ctrlKey || e.metaKey;
  if (e.key === "Escape") return Al();
  if (Vl(e.target)) {
    if (t && e.key.toLowerCase() === "k") Ze(e, "palette");
    return;
  }
  if (t && !e.altKey) {
    if (Va() && Ha(e)) return e.preventDefault();
    const i = Rl(e);
    if (i) Ze(e, i);
    return;
  }
  if (e.altKey) {
    const i = /^Digit(\d)$/.exec(e.code)?.[1];
    if (e.key === "ArrowLeft") return Ze(e, "back");
    if (e.key === "ArrowRight") return Ze(e, "forth");
    if (i === "0") return Ze(e, "store-view");
    if (i) {
      e.preventDefault();
      const s = st.all()[Number(i) - 1];
      if (s) j(s[1], s[1].name ?? "view");
      return;
    }
    if (e.code === "KeyH") Ze(e, "unhide");
    if (!(e.code in Ir)) return;
  }
  const n = Va();
  if (n && Ha(e)) return e.preventDefault();
  if (n && e.code in Ir) {
    So = e.shiftKey ? 4 : e.altKey ? 0.25 : 1;
    An(e.code);
    return e.preventDefault();
  }
  if (n && (e.key === "+" || e.key === "=")) return Da(0.85);
  if (n && (e.key === "-" || e.key === "_")) return Da(1 / 0.85);
  if (!ia.peek()) return;
  if (e.shiftKey && Aa[e.code]) return Ze(e, Aa[e.code]);
  if (xo && /^\d$/.test(e.key)) {
    e.preventDefault();
    xo = false;
    const i = lt.ids.peek()[Number(e.key) - 1];
    if (i !== void 0) Ke({ do: "look", id: i, what: "recall", seconds: $t.peek() });
    return;
  }
  xo = e.key.toLowerCase() === "j";
  if (xo) return G("Recall a look: now its digit.");
  if (!e.shiftKey && /^\d$/.test(e.key) && F.peek().length) {
    e.preventDefault();
    _a.value = e.key;
    return;
  }
  if (!e.shiftKey && Ra[e.code]) return Ze(e, Ra[e.code]);
  if (e.key === "\\") return void (e.repeat || Wt(true));
  const o = e.key.toLowerCase();
  if (o === "l" && !e.shiftKey) return void (e.repeat || B("highlight"));
  if (o === "p" && e.shiftKey) return Dl();
  const r = e.shiftKey && Ia[o] ? Ia[o] : Il[o];
  if (r && !(e.target instanceof HTMLButtonElement && o === "enter")) Ze(e, r);
}
function Dl() {
  const [e, t] = Le.peek();
  const n = Gt(e / 2, t / 2);
  if (n) ke("point", n, (o) => o.hit && wo(e / 2, t / 2, o));
}
function Ze(e, t) {
  e.preventDefault();
  B(t);
}
function Ol(e) {
  en.delete(e.code);
  if (e.key === "\\") Wt(false);
  if (e.key.toLowerCase() === "l") xn(false);
  if (e.key === "Shift") So = 1;
}
function Ka() {
  addEventListener("keydown", Hl);
  addEventListener("keyup", Ol);
  addEventListener("blur", () => {
    en.clear();
    xn(false);
    Wt(false);
  });
  const e = navigator.keyboard;
  void e?.getLayoutMap().then((t) => {
    Pl.value = ["KeyW", "KeyA", "KeyS", "KeyD"].map((n) => (t.get(n) ?? n.slice(3)).toUpperCase()).join(" ");
  }).catch(() => void 0);
}
function Fa(e, t) {
  for (const n of ["KeyW", "KeyS", "KeyA", "KeyD"]) en.delete(n);
  So = Math.min(1, Math.hypot(e, t));
  if (e > 0.2) An("KeyW");
  if (e < -0.2) An("KeyS");
  if (t < -0.2) An("KeyA");
  if (t > 0.2) An("KeyD");
}

// src/load.tsx
var qa = v(null);
var Na = false;
function gt({ part: e }) {
  const t = qa.value?.[e];
  return t ? /* @__PURE__ */ a(t, {}) : null;
}
function Ua() {
  T(() => {
    if (Na || !(te.value ?? M.value)) return;
    Na = true;
    const e = "./gizmo.js";
    setTimeout(() => void import(e).then((t) => qa.value = t), 0);
  });
}

// src/levels.ts
var ja = (e) => Math.min(1, zt.value === "square" ? Math.sqrt(Math.max(e, 0)) : e);
var Wa = (e) => {
  const t = zt.peek() === "square" ? e * e : e;
  return Math.round(t * 1e3) / 1e3;
};
var Kl = (e) => (e.kind === "lamp" ? y.get(e.id) : K.get(e.id))?.level ?? 0;
var Mo = (e) => (e.kind === "lamp" ? y.get(e.id) : K.get(e.id))?.name ?? "";
function Hr(e) {
  const t = F.peek();
  return e.kind === "lamp" && M.peek()?.kind === "lamp" && t.length > 1 && t.includes(e.id) ? t : [e.id];
}
function Ba(e, t, n) {
  if (e.kind === "group") return { groups: { [e.id]: { level: t } } };
  const o = n.get(e.id) ?? 0;
  const r = {};
  for (const [i, s] of n) {
    const l = i === e.id ? t : o > 0 ? Math.min(10, s * (t / o)) : t;
    r[i] = { level: Math.round(l * 1e3) / 1e3 };
  }
  return { lamps: r };
}
var Co = class {
  constructor(t) {
    this.strip = t;
    this.was = this.now = Kl(t);
    this.from = t.kind === "lamp" ? new Map(Hr(t).map((n) => [n, y.get(n)?.level ?? 0])) : /* @__PURE__ */ new Map();
    this.gesture = new Be(`${Mo(t)} level`);
  }
  strip;
  gesture;
  from;
  was;
  now;
  to(t) {
    this.now = t;
    this.gesture.set(Ba(this.strip, t, this.from));
  }
  end() {
    const t = this.from.size > 1 ? Pe([...this.from.keys()]) : Mo(this.strip);
    this.gesture.end(`${t} ${Qe(this.was)} → ${Qe(this.now)} %`);
  }
  cancel() {
    this.gesture.cancel();
  }
};
function Dr(e, t) {
  const n = new Map(Hr(e).map((o) => [o, y.get(o)?.level ?? 0]));
  Qi(`level ${e.kind} ${e.id}`, `${Mo(e)} level`, Ba(e, t, n));
}
function $o(e, t) {
  if (!e.length) return;
  const n = Object.fromEntries(e.map((r) => {
    const i = y.get(r);
    return [r, { level: t(i?.level ?? 0, i?.flux ?? 1) }];
  }));
  const o = e.length === 1 ? ` ${Qe(y.get(e[0])?.level ?? 0)} → ${Qe(n[e[0]].level)} %` : " level";
  oe(`${Pe(e)}${o}`, { lamps: n });
}
function Eo(e, t) {
  const n = t(K.get(e)?.level ?? 0);
  oe(`${K.get(e)?.name ?? "Group"} ${Qe(n)} %`, { groups: { [e]: { level: n } } });
}
function To(e, t) {
  const n = `${Mo(e)} ${t ? "on" : "off"}`;
  if (e.kind === "group") oe(n, { groups: { [e.id]: { on: t } } });
  else oe(n, { lamps: Object.fromEntries(Hr(e).map((o) => [o, { on: t }])) });
}

// src/swatch.ts
var Fl = (e) => e <= 31308e-7 ? 12.92 * e : 1.055 * e ** (1 / 2.4) - 0.055;
var Nl = (e) => Math.round(255 * Fl(Math.max(0, Math.min(1, e))));
function Po(e) {
  const t = Math.max(...e, 1e-6);
  return ql(e.map((n) => n / t));
}
function ql(e) {
  return `#${e.map((t) => Nl(t).toString(16).padStart(2, "0")).join("")}`;
}

// src/faderrow.tsx
function Vo(e) {
  const t = e.color;
  if (t.mode === "kelvin") return `${R(t.kelvin)} K`;
  return t.mode === "rgb" ? "RGB" : t.mode === "xy" ? "x y" : "file";
}
var Lo = (e) => e.free ? "re-mix: level and colour cost no ray" : "re-trace: its light is traced anew";
function za({ row: e, index: t, count: n }) {
  const o = ee(null);
  const r = { kind: e.kind, id: e.id };
  const i = e.kind === "lamp" ? y.get(e.id) : void 0;
  const s = e.kind === "group" ? K.get(e.id) : void 0;
  const l = i ?? s;
  if (!l) return null;
  const d = s?.lamps ?? [e.id];
  const u = i ? i.flux : d.reduce((k, b) => k + (y.get(b)?.flux ?? 0) * (y.get(b)?.level ?? 0), 0);
  const c = i ? i.flux * Te(i) : d.reduce((k, b) => k + (y.get(b)?.flux ?? 0) * Te(y.get(b)), 0);
  const f = M.value?.kind === e.kind && M.value.ids.includes(e.id);
  const m = d.length > 0 && d.every((k) => Ee.value.includes(k));
  const p = Ee.value.length > 0 && !d.some((k) => Ee.value.includes(k));
  const _ = ie.value?.kind === e.kind && ie.value.id === e.id;
  const w = `${f ? "selected" : ""} ${l.on && !i?.parked ? "" : "off"} ${p ? "muted" : ""} ${_ ? "under" : ""}`;
  const S = {
    begin: () => o.current = new Co(r),
    end: () => {
      o.current?.end();
      o.current = null;
    },
    cancel: () => {
      o.current?.cancel();
      o.current = null;
    }
  };
  return /* @__PURE__ */ a(
    "div",
    {
      class: `fader-row depth-${e.depth} ${e.kind} ${w}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => ie.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => ie.value = null,
      children: [
        /* @__PURE__ */ a("button", { class: "icon power", "aria-pressed": l.on, "aria-label": `${l.name} on`, title: l.on ? "On (O)" : "Off (O)", onClick: () => To(r, !l.on), children: /* @__PURE__ */ a(E, { name: "power" }) }),
        s && /* @__PURE__ */ a("button", { class: "icon fold", "aria-expanded": !Lt.value.has(e.id), "aria-label": `Members of ${l.name}`, onClick: () => Ga(e.id), children: /* @__PURE__ */ a(E, { name: Lt.value.has(e.id) ? "right" : "down" }) }),
        /* @__PURE__ */ a("button", { class: "row-name", "aria-pressed": f, title: i ? `${i.name}: ${Lo(i)}` : l.name, onClick: (k) => Io(k, e.kind, e.id), children: [
          /* @__PURE__ */ a("span", { children: l.name }),
          s && /* @__PURE__ */ a("small", { children: d.length }),
          i?.parked && /* @__PURE__ */ a("small", { children: "parked" }),
          i && !i.free && /* @__PURE__ */ a("small", { class: "traced", title: Lo(i), children: "re-trace" })
        ] }),
        i && /* @__PURE__ */ a("span", { class: "tint", children: [
          /* @__PURE__ */ a("i", { class: "swatch", style: { background: Po(i.swatch) } }),
          Vo(i)
        ] }),
        /* @__PURE__ */ a("button", { class: "icon solo", "aria-pressed": m, "aria-label": `Solo ${l.name}`, title: "Solo (I)", onClick: () => hr(d), children: /* @__PURE__ */ a(E, { name: "solo" }) }),
        /* @__PURE__ */ a(
          Zt,
          {
            label: `${l.name} level`,
            class: "level",
            value: ja(l.level),
            text: `${Qe(l.level)} %, ${Je(c)} lumen`,
            notch: 0.01,
            on: (k) => {
              const b = Wa(k);
              if (o.current) o.current.to(b);
              else Dr(r, b);
            },
            reset: () => Dr(r, 1),
            ...S
          }
        ),
        /* @__PURE__ */ a(
          Fe,
          {
            label: `${l.name} level, typed`,
            quantity: "level",
            value: l.level,
            flux: u,
            step: 0.01,
            set: (k) => i ? $o(f && F.peek().length > 1 ? F.peek() : [e.id], k) : Eo(e.id, k)
          }
        ),
        /* @__PURE__ */ a("span", { class: "lumens", children: ko(c, "flux") })
      ]
    }
  );
}

// src/sheetrow.tsx
function Xa() {
  return /* @__PURE__ */ a("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    /* @__PURE__ */ a("span", {}),
    /* @__PURE__ */ a("span", { children: "Name" }),
    /* @__PURE__ */ a("span", { children: "Level" }),
    /* @__PURE__ */ a("span", { children: "lm" }),
    /* @__PURE__ */ a("span", { children: "White" })
  ] });
}
function Ya({ row: e, index: t, count: n }) {
  const o = e.kind === "lamp" ? y.get(e.id) : void 0;
  const r = e.kind === "group" ? K.get(e.id) : void 0;
  const i = o ?? r;
  if (!i) return null;
  const s = M.value?.kind === e.kind && M.value.ids.includes(e.id);
  const l = o ? o.flux * Te(o) : (r?.lamps ?? []).reduce((u, c) => {
    const f = y.get(c);
    return u + (f ? f.flux * Te(f) : 0);
  }, 0);
  const d = ie.value?.kind === e.kind && ie.value.id === e.id;
  return /* @__PURE__ */ a(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${s ? "selected" : ""} ${i.on ? "" : "off"} ${d ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => ie.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => ie.value = null,
      children: [
        /* @__PURE__ */ a("button", { class: "icon power", "aria-pressed": i.on, "aria-label": `${i.name} on`, onClick: () => To(e, !i.on), children: /* @__PURE__ */ a(E, { name: "power" }) }),
        /* @__PURE__ */ a("button", { class: "row-name", "aria-pressed": s, title: o ? Lo(o) : void 0, onClick: (u) => Io(u, e.kind, e.id), onDblClick: () => B("frame"), children: /* @__PURE__ */ a("span", { children: i.name }) }),
        /* @__PURE__ */ a(
          Fe,
          {
            label: `${i.name} level`,
            quantity: "level",
            value: i.level,
            flux: o?.flux,
            step: 0.01,
            set: (u) => o ? $o([e.id], u) : Eo(e.id, u)
          }
        ),
        /* @__PURE__ */ a("span", { class: "lumens", children: Je(l) }),
        o ? /* @__PURE__ */ a("button", { class: "tint", "aria-label": `${i.name} colour: ${Vo(o)}`, onClick: () => de("lamp", e.id), children: [
          /* @__PURE__ */ a("i", { class: "swatch", style: { background: Po(o.swatch) } }),
          Vo(o)
        ] }) : /* @__PURE__ */ a("span", {})
      ]
    }
  );
}

// src/virtual.tsx
var Ja = 4;
function Qa({ count: e, height: t, row: n, label: o, show: r, role: i = "list" }) {
  const s = ee(null);
  const l = rt(0);
  const d = rt(600);
  Ie(() => {
    const f = s.current;
    const m = new ResizeObserver(() => d.value = f.clientHeight);
    m.observe(f);
    return () => m.disconnect();
  }, []);
  Ie(() => {
    const f = s.current;
    if (!f || r === void 0 || r < 0) return;
    const m = r * t;
    if (m < f.scrollTop || m + t > f.scrollTop + f.clientHeight) {
      f.scrollTop = Math.max(0, m - f.clientHeight / 2);
    }
  }, [r, t]);
  const u = Math.max(0, Math.floor(l.value / t) - Ja);
  const c = Math.min(e, Math.ceil((l.value + d.value) / t) + Ja);
  return /* @__PURE__ */ a("div", { class: "virtual", ref: s, tabIndex: e ? void 0 : -1, onScroll: (f) => l.value = f.currentTarget.scrollTop, children: /* @__PURE__ */ a("div", { class: "all", role: i, "aria-label": o, style: { height: `${e * t}px` }, children: /* @__PURE__ */ a("div", { class: "rows", role: "presentation", style: { transform: `translateY(${u * t}px)` }, children: Array.from({ length: Math.max(0, c - u) }, (f, m) => n(u + m)) }) }) });
}

// src/lamps.tsx
var Ro = v("");
var Lt = v(/* @__PURE__ */ new Set());
var Ao = v("group");
var es = Y(() => {
  const e = Ro.value.trim().toLowerCase();
  const t = (r) => {
    const i = y.get(r);
    if (!i) return false;
    return !e || `${i.name} ${i.kind} ${K.get(i.group)?.name ?? ""}`.toLowerCase().includes(e);
  };
  if (Ao.value !== "group" && dt.value === "sheet") {
    const r = Ao.value;
    const i = y.all().filter(([s]) => t(s));
    i.sort(([, s], [, l]) => r === "name" ? s.name.localeCompare(l.name, "en", { numeric: true }) : l[r] - s[r]);
    return i.map(([s]) => ({ kind: "lamp", id: s, depth: 0 }));
  }
  const n = [];
  const o = /* @__PURE__ */ new Set();
  for (const [r, i] of K.all()) {
    i.lamps.forEach((l) => o.add(l));
    const s = i.lamps.filter(t);
    if (!s.length) continue;
    if (i.lamps.length === 1) {
      n.push({ kind: "lamp", id: s[0], depth: 0 });
      continue;
    }
    n.push({ kind: "group", id: r, depth: 0 });
    if (!Lt.value.has(r) || e) s.forEach((l) => n.push({ kind: "lamp", id: l, depth: 1 }));
  }
  for (const r of y.ids.value) if (!o.has(r) && t(r)) n.push({ kind: "lamp", id: r, depth: 0 });
  return n;
});
var Za = false;
K.ids.subscribe((e) => {
  if (Za || !e.length) return;
  Za = true;
  if (y.ids.peek().length > 40) Lt.value = new Set(e.filter((t) => (K.get(t)?.lamps.length ?? 0) > 1));
});
function Ga(e) {
  const t = new Set(Lt.peek());
  if (!t.delete(e)) t.add(e);
  Lt.value = t;
}
function Io(e, t, n) {
  if (e.shiftKey) ta(t, es.peek().filter((o) => o.kind === t).map((o) => o.id), n);
  else de(t, n, e.ctrlKey || e.metaKey ? "toggle" : "only");
}
function Ul(e) {
  const t = { ArrowDown: 1, ArrowUp: -1 }[e.key];
  const n = e.target;
  if (!t || !n.matches(".row-name")) return;
  e.preventDefault();
  const o = [...e.currentTarget.querySelectorAll(".row-name")];
  o[o.indexOf(n) + t]?.focus();
}
var jl = ["add-spot", "add-point", "add-disc", "add-sphere"];
function ts() {
  const e = es.value;
  const t = M.value?.ids[M.value.ids.length - 1];
  const n = e.findIndex((i) => i.kind === M.value?.kind && i.id === t);
  const o = matchMedia("(pointer: coarse)").matches;
  const r = dt.value === "sheet";
  return /* @__PURE__ */ a("section", { class: "panel lamps", "aria-label": "Lamps", onKeyDown: Ul, children: [
    /* @__PURE__ */ a("header", { class: "panel-head", children: [
      /* @__PURE__ */ a("h2", { children: [
        "Lamps ",
        /* @__PURE__ */ a("small", { children: R(y.ids.value.length) })
      ] }),
      /* @__PURE__ */ a("span", { class: "gap" }),
      /* @__PURE__ */ a("div", { class: "segments", role: "group", "aria-label": "Listing", children: [
        /* @__PURE__ */ a("button", { "aria-pressed": !r, onClick: () => dt.value = "faders", children: "Faders" }),
        /* @__PURE__ */ a("button", { "aria-pressed": r, onClick: () => dt.value = "sheet", children: "Sheet" })
      ] })
    ] }),
    /* @__PURE__ */ a("div", { class: "panel-tools", children: [
      /* @__PURE__ */ a("span", { class: "field filter", children: /* @__PURE__ */ a(
        "input",
        {
          type: "text",
          "aria-label": "Filter lamps",
          placeholder: "Filter",
          value: Ro.value,
          onInput: (i) => Ro.value = i.currentTarget.value,
          onKeyDown: (i) => {
            if (i.key !== "Escape") return;
            Ro.value = "";
            i.stopPropagation();
          }
        }
      ) }),
      r && /* @__PURE__ */ a("select", { "aria-label": "Order", value: Ao.value, onChange: (i) => Ao.value = i.currentTarget.value, children: [
        /* @__PURE__ */ a("option", { value: "group", children: "by group" }),
        /* @__PURE__ */ a("option", { value: "name", children: "by name" }),
        /* @__PURE__ */ a("option", { value: "flux", children: "by flux" }),
        /* @__PURE__ */ a("option", { value: "level", children: "by level" })
      ] }),
      /* @__PURE__ */ a(Jt, { id: "add-menu", label: "Add", title: "Add a lamp", children: [
        jl.map((i) => /* @__PURE__ */ a(Ne, { id: i }, i)),
        /* @__PURE__ */ a("button", { class: "item", "aria-disabled": "true", title: "Photometric files come with a later version", children: [
          /* @__PURE__ */ a("span", { children: "IES or LDT file…" }),
          /* @__PURE__ */ a("kbd", { children: "later" })
        ] })
      ] })
    ] }),
    F.value.length > 1 && /* @__PURE__ */ a("p", { class: "several", children: [
      F.value.length,
      " selected; a fader moves them in proportion",
      /* @__PURE__ */ a("button", { onClick: () => B("none"), children: "None" })
    ] }),
    r && /* @__PURE__ */ a(Xa, {}),
    /* @__PURE__ */ a(
      Qa,
      {
        label: "Lamps and groups",
        count: e.length,
        height: r ? o ? 44 : 28 : o ? 84 : 50,
        show: n,
        row: (i) => {
          const s = e[i];
          const l = r ? Ya : za;
          return /* @__PURE__ */ a(l, { row: s, index: i, count: e.length }, `${s.kind}${s.id}`);
        }
      }
    ),
    !e.length && y.ids.value.length > 0 && /* @__PURE__ */ a("p", { class: "quiet empty", children: "No lamp is called so." })
  ] });
}

// src/states.ts
var Hn = v(null);
var bt = v([]);
var Dn = v(null);
var Kr = v(null);
var Or = Y(() => ge.value?.stage ?? "loading");
var Wl = Y(() => {
  const e = ge.value?.fps ?? 0;
  return Or.value === "moving" && e > 6 && Ut.value < 0.4 * e && Ut.value < 5;
});
var tn = Y(() => {
  switch (Q.value) {
    case "entering":
      return "starting";
    case "open":
      break;
    default:
      return Q.value;
  }
  if (!z.value || !te.value) return "loading";
  if (xt.value.state === "failed") return "unsaved";
  if (Hn.value !== null) return "broken";
  if (Dn.value !== null && !re.value.you) return "control-lost";
  if (_e.value === "watch" || !re.value.you) return "watching";
  if (y.ids.value.length === 0) return "no-lamps";
  if (Fi.value) return "all-off";
  if (Wl.value) return "slow";
  if (Or.value === "loading") return "first";
  return Or.value;
});
Ae("event", (e) => {
  switch (e.what) {
    case "reloaded": {
      Hn.value = null;
      bt.value = e.lost ?? [];
      const t = e.kept ?? 0;
      G(`The scene was read again: ${t} edits kept${bt.value.length ? `, ${bt.value.length} no longer find what they changed` : ""}.`);
      break;
    }
    case "broken":
      Hn.value = e.why ?? "The scene file cannot be read.";
      break;
    case "taken":
      Dn.value = e.by ?? re.peek().name ?? "somebody else";
      break;
    case "loading":
      Kr.value = e;
      break;
  }
});
Ae("refused", (e) => G(e.why ?? "That could not be done.", "warn"));
T(() => {
  if (re.value.you) Dn.value = null;
});

// src/probe.ts
var Ho = v(null);
function Do(e, t, n) {
  const o = Gt(e, t);
  if (!o) return n(null);
  ke("point", o, (r) => n(r.hit ? r : null));
}
function ns(e) {
  if (!e) return "";
  const t = [];
  const n = y.get(e.lamp)?.name;
  const o = pe.get(e.thing)?.name;
  const r = vn.get(e.material)?.name;
  if (n) t.push(n);
  if (o && o !== n) t.push(o);
  if (r && r !== o) t.push(r);
  if (e.lux) t.push(`${be(e.lux[0])} ±${be(e.lux[1], false)}`);
  if (e.luminance) {
    const i = e.luminance[0] * (ft.value === "fc" ? 0.2919 : 1);
    t.push(`${Je(i)} ${ft.value === "fc" ? "fL" : "cd/m²"}`);
  }
  return t.join(" · ");
}

// src/status.tsx
var os = Y(() => {
  void te.value;
  const e = [];
  for (const t of le.sent.slice(-24)) {
    if (t.what !== "set" && t.what !== "camera") continue;
    const n = le.frames.find((o) => o.seq >= t.seq && o.painted);
    if (n && n.painted > t.at) e.push(n.painted - (t.input || t.at));
  }
  e.sort((t, n) => t - n);
  return e.length ? e[e.length >> 1] : null;
});
function Bl() {
  const e = ge.value;
  if (!e) return "starting";
  const t = e.error === null ? "" : ` ±${R(e.error * 100, e.error < 0.0995 ? 1 : 0)} %`;
  switch (e.stage) {
    case "loading":
      return "first look";
    case "moving":
      return `moving${t}`;
    case "refining":
      return `${t.trim() || "refining"}${e.good_in ? `, good in ${R(e.good_in, e.good_in < 3 ? 1 : 0)} s` : ""}`;
    case "good":
      return `good${t}`;
    case "done":
      return `finished${t}`;
  }
}
function rs() {
  const e = ge.value;
  const t = te.value?.head;
  const n = ro.value.filter((r) => r.batches < r.of && !r.held).length;
  const o = e?.stage === "refining" && e.good_in ? Math.max(0.02, 1 / (1 + e.good_in)) : e?.stage === "good" || e?.stage === "done" ? 1 : 0.02;
  return /* @__PURE__ */ a("footer", { class: "status", "aria-label": "Status", children: [
    /* @__PURE__ */ a("span", { class: `quality ${e?.stage ?? ""}`, children: [
      /* @__PURE__ */ a("i", { class: "thin", "aria-hidden": "true", children: /* @__PURE__ */ a("b", { style: { width: `${o * 100}%` } }) }),
      Bl()
    ] }),
    /* @__PURE__ */ a("span", { children: [
      R(t?.batches ?? e?.batches ?? 0),
      " batches"
    ] }),
    /* @__PURE__ */ a("span", { children: Q.value === "open" ? `${R(Ut.value)} fps` : "no line" }),
    os.value !== null && /* @__PURE__ */ a("span", { title: "From the hand to the paint, median", children: [
      R(os.value),
      " ms"
    ] }),
    t && /* @__PURE__ */ a("span", { children: [
      t.width,
      " × ",
      t.height
    ] }),
    /* @__PURE__ */ a("span", { class: "wide", children: [
      ro.value.length,
      " layers",
      n ? `, ${n} tracing` : ""
    ] }),
    /* @__PURE__ */ a("span", { class: "probe", "aria-live": "off", children: ns(Ho.value) }),
    /* @__PURE__ */ a("span", { class: "gap" }),
    /* @__PURE__ */ a("span", { children: re.value.you ? "editing: you" : `editing: ${re.value.name ?? "somebody else"}` }),
    /* @__PURE__ */ a("span", { class: "spoken", children: [
      lr.value ?? "",
      " ",
      tn.value
    ] })
  ] });
}

// src/csv.ts
var zl = (e) => {
  const t = e === null || e === void 0 ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function Gl() {
  const e = mo.peek();
  const t = [["scene", z.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (const [, n] of ve.all()) {
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  }
  for (const [, n] of $e.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    const o = { mean: n.mean, min: n.min, max: n.max };
    for (const [r, i] of Object.entries(o)) t.push([r, i === null ? null : i * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]);
    n.lux.forEach((r, i) => {
      const [s, l] = [i % n.columns, Math.floor(i / n.columns)];
      const d = C(n.corner, C(x(n.u, (s + 0.5) / n.columns), x(n.v, (l + 0.5) / n.rows)));
      t.push([...d.map((u) => u.toFixed(3)), r === null ? null : r * e]);
    });
  }
  return t.map((n) => n.map(zl).join(",")).join("\r\n") + "\r\n";
}
function Xl(e, t) {
  const n = document.createElement("a");
  n.href = t;
  n.download = e;
  document.body.append(n);
  n.click();
  n.remove();
}
function is() {
  const e = URL.createObjectURL(new Blob([Gl()], { type: "text/csv" }));
  Xl(`${z.peek()?.name ?? "figures"}.csv`, e);
  setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/strip.tsx
var Fr = v("looks");
function Yl() {
  return /* @__PURE__ */ a("section", { class: "looks", "aria-label": "Looks", children: [
    /* @__PURE__ */ a("header", { children: [
      /* @__PURE__ */ a("h2", { children: "Looks" }),
      /* @__PURE__ */ a("button", { class: "tab", onClick: () => Fr.value = "meters", children: "Meters" }),
      /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: $r, children: /* @__PURE__ */ a(E, { name: "plus" }) }),
      /* @__PURE__ */ a("span", { class: "gap" }),
      /* @__PURE__ */ a("label", { class: "tint", children: [
        "Fade",
        /* @__PURE__ */ a(Fe, { label: "Cross-fade", quantity: "seconds", value: $t.value, step: 0.5, set: (e) => $t.value = Math.max(0, e($t.value)) })
      ] })
    ] }),
    /* @__PURE__ */ a("ul", { children: [
      lt.all().map(([e, t], n) => /* @__PURE__ */ a("li", { class: "look", children: [
        /* @__PURE__ */ a("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Ke({ do: "look", id: e, what: "recall", seconds: $t.peek() }), children: [
          t.picture && /* @__PURE__ */ a("img", { src: t.picture, alt: "" }),
          /* @__PURE__ */ a("span", { children: t.name })
        ] }),
        /* @__PURE__ */ a(Jl, { id: e, name: t.name })
      ] }, e)),
      !lt.ids.value.length && /* @__PURE__ */ a("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function Jl({ id: e, name: t }) {
  const n = `look-${e}`;
  const o = (l) => {
    const d = l.getBoundingClientRect();
    const u = document.getElementById(n);
    u?.style.setProperty("left", `${Math.min(d.left, innerWidth - 296)}px`);
    u?.style.setProperty("bottom", `${innerHeight - d.top + 4}px`);
    u?.style.setProperty("top", "auto");
  };
  const r = { popovertarget: n };
  const i = () => document.getElementById(n)?.hidePopover();
  const s = (l, d = {}) => {
    i();
    Ke({ do: "look", id: e, what: l, ...d });
  };
  return /* @__PURE__ */ a(X, { children: [
    /* @__PURE__ */ a("button", { class: "icon more", ...r, "aria-label": `More of ${t}`, onPointerDown: (l) => o(l.currentTarget), onFocus: (l) => o(l.currentTarget), children: /* @__PURE__ */ a(E, { name: "more" }) }),
    /* @__PURE__ */ a("div", { id: n, popover: "auto", class: "menu", children: [
      /* @__PURE__ */ a("label", { class: "line", children: [
        /* @__PURE__ */ a("span", { children: "Name" }),
        /* @__PURE__ */ a("span", { class: "field", children: /* @__PURE__ */ a("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (l) => s("rename", { name: l.currentTarget.value }) }) })
      ] }),
      /* @__PURE__ */ a("button", { class: "item", onClick: () => s("update"), children: /* @__PURE__ */ a("span", { children: "Update to what is set now" }) }),
      /* @__PURE__ */ a("button", { class: "item", onClick: () => s("recall", { seconds: 0 }), children: /* @__PURE__ */ a("span", { children: "Recall at once" }) }),
      /* @__PURE__ */ a("button", { class: "item", onClick: () => s("remove"), children: /* @__PURE__ */ a("span", { children: "Remove" }) })
    ] })
  ] });
}
var as = () => ge.value?.stage === "moving" || ge.value?.stage === "refining" || ge.value?.stage === "loading";
function Ql() {
  const e = mo.value;
  return /* @__PURE__ */ a("section", { class: "readings", "aria-label": "Meters and grids", children: [
    /* @__PURE__ */ a("header", { children: [
      /* @__PURE__ */ a("h2", { children: "Meters" }),
      /* @__PURE__ */ a("button", { class: "tab", onClick: () => Fr.value = "looks", children: "Looks" }),
      /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => B("meter-tool"), children: /* @__PURE__ */ a(E, { name: "meter" }) }),
      /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => B("grid"), children: /* @__PURE__ */ a(E, { name: "grid" }) }),
      /* @__PURE__ */ a("button", { onClick: is, title: "Save all figures as CSV", children: "CSV" }),
      /* @__PURE__ */ a("span", { class: "gap" }),
      /* @__PURE__ */ a("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${R(e, 2)} maintained` })
    ] }),
    /* @__PURE__ */ a("ul", { children: [
      ve.all().map(([t, n]) => {
        const o = n.lux;
        const r = !o || o[1] > 0.02 * o[0] || as();
        return /* @__PURE__ */ a("li", { children: /* @__PURE__ */ a("button", { class: "reading", "aria-pressed": M.value?.kind === "meter" && M.value.ids.includes(t), onClick: () => de("meter", t), children: [
          /* @__PURE__ */ a("span", { class: "tint", children: [
            /* @__PURE__ */ a(E, { name: "meter" }),
            n.name
          ] }),
          /* @__PURE__ */ a("strong", { class: r ? "unsettled" : "", children: o ? be(o[0] * e) : "…" }),
          /* @__PURE__ */ a("small", { children: [
            o ? `±${be(o[1] * e, false)}` : "measuring",
            " ",
            n.kind
          ] })
        ] }) }, `m${t}`);
      }),
      $e.all().map(([t, n]) => {
        const o = n.target;
        const r = o && n.mean !== null && n.uniformity !== null && n.mean * e >= o.lux && n.uniformity >= o.uniformity;
        return /* @__PURE__ */ a("li", { children: /* @__PURE__ */ a("button", { class: "reading", "aria-pressed": M.value?.kind === "grid" && M.value.ids.includes(t), onClick: () => de("grid", t), children: [
          /* @__PURE__ */ a("span", { class: "tint", children: [
            /* @__PURE__ */ a(E, { name: "grid" }),
            n.name,
            " ",
            o && n.mean !== null && /* @__PURE__ */ a("b", { class: r ? "met" : "missed", children: r ? "✓" : "✗" })
          ] }),
          /* @__PURE__ */ a("strong", { class: as() ? "unsettled" : "", children: n.mean === null ? "…" : `Ē ${be(n.mean * e)}` }),
          /* @__PURE__ */ a("small", { children: [
            "U₀ ",
            n.uniformity === null ? "…" : R(n.uniformity, 2),
            " · ",
            n.min === null ? "…" : be(n.min * e, false),
            " to",
            " ",
            n.max === null ? "…" : be(n.max * e, false),
            o ? ` · wants ${be(o.lux)}, U₀ ${R(o.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !ve.ids.value.length && !$e.ids.value.length && /* @__PURE__ */ a("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function ss() {
  return /* @__PURE__ */ a("section", { class: "strip", "aria-label": "Looks and meters", "data-tab": Fr.value, children: [
    /* @__PURE__ */ a(Yl, {}),
    /* @__PURE__ */ a(Ql, {})
  ] });
}

// src/pointer.ts
var Zl = 4;
var ls = 35e-4;
var eu = 0.15;
function tu(e, t, n) {
  if (e === "maya" && n.alt) return ["orbit", "pan", "dolly"][t] ?? "none";
  if (e === "blender" && t === 1) return n.shift ? "pan" : n.ctrl ? "dolly" : "orbit";
  if (t === 1) return n.shift ? "pan" : "orbit";
  if (t === 2) return "look";
  if (t === 0) return n.alt ? "orbit" : n.space ? "pan" : n.shift || n.ctrl ? "none" : "look";
  return "none";
}
function us(e, t) {
  const n = /* @__PURE__ */ new Map();
  let o = Xt();
  let r = 3;
  let i = false;
  let s = 0;
  let l = 0;
  let d = 0;
  let u = null;
  const c = (h) => {
    const g = e.getBoundingClientRect();
    return [h.clientX - g.left, h.clientY - g.top];
  };
  const f = (h, g, P) => {
    const L = Gt(h, g);
    if (!L) return;
    ke("point", L, (V) => {
      const A = V;
      if (A.hit) P?.(A);
    });
  };
  const m = (h) => {
    const g = Tt();
    return g ? Math.max(0.2, W(H(h, g.eye), g.forward)) : r;
  };
  function p(h) {
    if (h.target.closest("[data-handle]")) return;
    e.focus({ preventScroll: true });
    const [g, P] = c(h);
    const L = h.pointerType === "touch";
    const V = { alt: h.altKey, shift: h.shiftKey, ctrl: h.ctrlKey || h.metaKey, space: i };
    let A = L ? "look" : tu(Sn.peek(), h.button, V);
    if (A === "look" && ae()?.height) A = "pan";
    if (U.peek() === "marquee" && h.button === 0) A = "none";
    n.set(h.pointerId, {
      id: h.pointerId,
      button: h.button,
      x: g,
      y: P,
      startX: g,
      startY: P,
      moved: false,
      motion: A,
      touch: L,
      shift: h.shiftKey,
      ctrl: V.ctrl
    });
    e.setPointerCapture(h.pointerId);
    clearTimeout(s);
    t.unhover();
    if (A === "orbit" || A === "pan" || A === "dolly") {
      o = Xt();
      r = m(o);
      f(g, P, (O) => {
        o = O.point;
        r = m(O.point);
      });
    }
    clearTimeout(l);
    if (L && n.size === 1) {
      l = window.setTimeout(() => {
        const O = n.get(h.pointerId);
        if (O && !O.moved && n.size === 1) {
          O.moved = true;
          O.motion = "none";
          t.menu(O.x, O.y);
        }
      }, 550);
    }
    if (n.size === 2) u = _();
    if (h.button === 1) h.preventDefault();
  }
  function _() {
    const [h, g] = [...n.values()];
    return { gap: Math.hypot(h.x - g.x, h.y - g.y), x: (h.x + g.x) / 2, y: (h.y + g.y) / 2 };
  }
  function w(h) {
    const g = n.get(h.pointerId);
    const [P, L] = c(h);
    if (!g) {
      if (h.pointerType === "touch" || h.buttons) return;
      t.unhover();
      clearTimeout(s);
      s = window.setTimeout(() => t.hover(P, L), 150);
      return;
    }
    const [V, A] = [P - g.x, L - g.y];
    if (!g.moved && Math.hypot(P - g.startX, L - g.startY) < Zl) return;
    g.moved = true;
    g.x = P;
    g.y = L;
    if (n.size === 2 && u) {
      const O = _();
      Yt(O.x - u.x, O.y - u.y, r);
      if (O.gap > 8 && u.gap > 8) b(O.x, O.y, u.gap / O.gap, false);
      u = O;
      return;
    }
    if (U.peek() === "marquee" && g.button === 0) {
      t.marquee([g.startX, g.startY], [P, L], false);
      return;
    }
    switch (g.motion) {
      case "look": {
        const O = g.touch ? 1 : -1;
        vo(O * V * ls, O * A * ls);
        break;
      }
      case "orbit":
        go(o, -V * 6e-3, -A * 6e-3);
        break;
      case "pan":
        Yt(V, A, r);
        break;
      case "dolly":
        b(g.startX, g.startY, Math.exp(A * 6e-3), false);
        break;
      case "none":
        break;
    }
  }
  function S(h) {
    const g = n.get(h.pointerId);
    n.delete(h.pointerId);
    clearTimeout(l);
    if (n.size < 2) u = null;
    if (!g || h.type === "pointercancel") return;
    if (g.moved) {
      if (U.peek() === "marquee") t.marquee([g.startX, g.startY], [g.x, g.y], true);
      return;
    }
    if (g.touch) {
      const P = performance.now();
      const L = P - d < 320;
      d = P;
      if (L) return t.double();
      if (xe.peek()) return;
    }
    if (g.button === 2) t.menu(g.x, g.y);
    else if (g.button === 0) {
      const P = g.shift ? "add" : g.ctrl ? "toggle" : "only";
      t.click(g.x, g.y, P);
    }
  }
  let k = null;
  function b(h, g, P, L) {
    const V = ae();
    const A = Tt();
    if (!V || !A) return;
    if (V.height) return j(no(V, A, h, g, P));
    const O = performance.now();
    if (!k || O - k.time > 500 || Math.hypot(h - k.x, g - k.y) > 6) {
      k = { x: h, y: g, time: O, point: null };
      const It = k;
      f(h, g, (jr) => {
        It.point = jr.point;
        r = m(jr.point);
      });
    }
    k.time = O;
    const [ks, ws] = [h - A.width / 2, A.height / 2 - g];
    const xs = Math.min(r, Ue(V.eye, Xt()) + 1);
    const Oo = (It) => V.eye[It] + (A.forward[It] + A.side[It] * ks * A.pixel + A.up[It] * ws * A.pixel) * xs;
    const Ss = k.point ?? [Oo(0), Oo(1), Oo(2)];
    j(to(V, Ss, P, eu, L));
  }
  function D(h) {
    if (h.target.closest("[data-scroll]")) return;
    h.preventDefault();
    const g = h.deltaMode === 1 ? 18 : h.deltaMode === 2 ? 400 : 1;
    const [P, L] = [h.deltaX * g, h.deltaY * g];
    const [V, A] = c(h);
    if (Sn.peek() === "trackpad" && !h.ctrlKey) return Yt(-P, -L, r);
    const O = (h.ctrlKey ? 6 : 1) * (Math.abs(L) > Math.abs(P) ? L : P);
    b(V, A, Math.exp(Math.max(-300, Math.min(300, O)) * 16e-4), h.shiftKey && !h.ctrlKey);
  }
  const I = (h) => h.preventDefault();
  const et = () => {
    clearTimeout(s);
    t.unhover();
  };
  const tt = (h) => {
    if (!h.target.closest("[data-handle]") && U.peek() === null) t.double();
  };
  const Ce = (h) => {
    if (h.code === "Space") i = h.type === "keydown";
  };
  const ye = new ResizeObserver(() => {
    const h = e.getBoundingClientRect();
    Le.value = [Math.max(16, Math.round(h.width)), Math.max(16, Math.round(h.height))];
  });
  ye.observe(e);
  e.addEventListener("pointerdown", p);
  e.addEventListener("pointermove", w);
  e.addEventListener("pointerup", S);
  e.addEventListener("pointercancel", S);
  e.addEventListener("pointerleave", et);
  e.addEventListener("wheel", D, { passive: false });
  e.addEventListener("contextmenu", I);
  e.addEventListener("dblclick", tt);
  addEventListener("keydown", Ce);
  addEventListener("keyup", Ce);
  return () => {
    ye.disconnect();
    removeEventListener("keydown", Ce);
    removeEventListener("keyup", Ce);
  };
}

// src/overlay.ts
var nu = "http://www.w3.org/2000/svg";
function Me(e, t = {}, n) {
  const o = document.createElementNS(nu, e);
  for (const [r, i] of Object.entries(t)) o.setAttribute(r, String(i));
  n?.append(o);
  return o;
}
var qr = class {
  view;
  fit;
  constructor(t) {
    this.view = t;
    this.fit = ho(t.width, t.height);
  }
  at(t) {
    const [n, o, r] = eo(this.view, t);
    if (r < 0.02 && !this.view.parallel) return null;
    return [this.fit.x + n * this.fit.scale, this.fit.y + o * this.fit.scale];
  }
  /** A line of the scene as a path, as much of it as lies before the eye. */
  line(t, n) {
    const [, , o] = eo(this.view, t);
    const [, , r] = eo(this.view, n);
    const i = 0.05;
    let [s, l] = [t, n];
    if (!this.view.parallel) {
      if (o < i && r < i) return "";
      const c = (i - o) / (r - o);
      const f = C(x(t, 1 - c), x(n, c));
      if (o < i) s = f;
      if (r < i) l = f;
    }
    const [d, u] = [this.at(s), this.at(l)];
    if (!d || !u) return "";
    return `M${d[0].toFixed(1)} ${d[1].toFixed(1)}L${u[0].toFixed(1)} ${u[1].toFixed(1)}`;
  }
};
function Ur() {
  const e = te.value;
  void Le.value;
  return e ? new qr(pn(e.camera, e.head.width, e.head.height)) : null;
}
function cs() {
  const e = se(Ur);
  if (!e) return null;
  return y.all().flatMap(([t, n]) => {
    const o = ps(n);
    const r = o && e.at(o);
    return r ? [{ id: t, at: r }] : [];
  });
}
var ps = (e) => e.place?.position ?? (e.box ? wt(e.box) : null);
var ou = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
function Nr(e, t) {
  const n = cn(t);
  return ou.map(([o, r]) => e.line(n[o], n[r])).join("");
}
var On = class {
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
    for (const { id: o, at: r, label: i, state: s } of t) {
      n.add(o);
      let l = this.marks.get(o);
      if (!l) {
        const d = Me("g", { "data-kind": this.kind, "data-id": o }, this.parent);
        this.shape(d);
        const u = Me("text", { x: 10, y: 4 }, d);
        l = { group: d, label: u };
        this.marks.set(o, l);
      }
      if (!r) {
        l.group.setAttribute("display", "none");
        continue;
      }
      l.group.removeAttribute("display");
      l.group.setAttribute("transform", `translate(${r[0].toFixed(1)} ${r[1].toFixed(1)})`);
      l.group.setAttribute("class", `mark ${this.kind} ${s}`);
      if (l.label.textContent !== i) l.label.textContent = i;
    }
    for (const [o, r] of this.marks) {
      if (n.has(o)) continue;
      r.group.remove();
      this.marks.delete(o);
    }
  }
};
function ds(e) {
  const t = Me("path", { class: "aims" }, e);
  const n = Me("path", { class: "boxes" }, e);
  const o = Me("path", { class: "boxes hover" }, e);
  const r = Me("path", { class: "grid-lines" }, e);
  const i = new On(Me("g", {}, e), "lamp", (c) => Me("circle", { r: 4.5 }, c));
  const s = new On(Me("g", {}, e), "grid", () => void 0);
  const l = new On(Me("g", {}, e), "meter", (c) => {
    Me("circle", { r: 5.5 }, c);
    Me("path", { d: "M-9 0H9M0 -9V9" }, c);
  });
  const d = T(() => {
    const c = Ur();
    if (!c) return;
    const f = M.value;
    const m = ie.value;
    let p = "";
    let _ = "";
    const w = y.all().map(([k, b]) => {
      const D = f?.kind === "lamp" ? f.ids.includes(k) : f?.kind === "group" && f.ids.includes(b.group ?? -1);
      const I = m?.kind === "lamp" ? m.id === k : m?.kind === "group" && m.id === b.group;
      const et = ps(b);
      const tt = b.place?.position;
      if (D && b.box) _ += Nr(c, b.box);
      if (tt && b.place?.direction && (D || I)) {
        const h = b.place.aim ?? C(tt, b.place.direction);
        p += c.line(tt, h);
      }
      const Ce = D || I || Cn.value && (b.own || b.place?.position);
      const ye = `${D ? "selected" : ""} ${I ? "under" : ""} ${Te(b) ? "" : "off"}`;
      return { id: k, at: et && Ce ? c.at(et) : null, label: D || I ? b.name : "", state: ye };
    });
    i.draw(w);
    t.setAttribute("d", p);
    if (f?.kind === "thing") {
      for (const k of f.ids) {
        const b = pe.get(k)?.box;
        if (b) _ += Nr(c, b);
      }
    }
    n.setAttribute("d", _);
    const S = m?.kind === "lamp" ? y.get(m.id)?.box : m?.kind === "thing" ? pe.get(m.id)?.box : null;
    o.setAttribute("d", S ? Nr(c, S) : "");
  });
  const u = T(() => {
    const c = Ur();
    if (!c) return;
    const f = M.value;
    const m = (_, w) => f?.kind === _ && f.ids.includes(w) ? "selected" : "";
    l.draw(ve.all().map(([_, w]) => ({
      id: _,
      at: c.at(w.point),
      label: w.lux ? be(w.lux[0]) : "…",
      state: m("meter", _)
    })));
    let p = "";
    s.draw($e.all().map(([_, w]) => {
      p += ru(c, w);
      const S = w.mean === null ? "…" : `${w.name} ${be(w.mean)}`;
      return { id: _, at: c.at(w.corner), label: S, state: m("grid", _) };
    }));
    r.setAttribute("d", p);
  });
  return () => {
    d();
    u();
    e.replaceChildren();
  };
}
function ru(e, t) {
  const n = (r, i) => C(t.corner, C(x(t.u, r), x(t.v, i)));
  let o = e.line(n(0, 0), n(1, 0)) + e.line(n(1, 0), n(1, 1)) + e.line(n(1, 1), n(0, 1)) + e.line(n(0, 1), n(0, 0));
  for (let r = 0; r < t.rows; r++) {
    for (let i = 0; i < t.columns; i++) {
      const s = e.at(n((i + 0.5) / t.columns, (r + 0.5) / t.rows));
      if (s) o += `M${(s[0] - 2).toFixed(1)} ${s[1].toFixed(1)}h4m-2 -2v4`;
    }
  }
  return o;
}

// src/banner.tsx
function me({ tone: e, children: t }) {
  return /* @__PURE__ */ a("div", { class: `banner ${e}`, role: e === "warn" ? "alert" : "status", children: t });
}
var fs = () => `lampyris view ${z.peek()?.file ?? "SCENE"} --port ${location.port || 80}`;
function iu() {
  const e = y.all().filter(([, n]) => !n.on || n.level === 0 || n.parked);
  const t = K.all().filter(([, n]) => !n.on || n.level === 0);
  oe("All lamps on", {
    lamps: Object.fromEntries(e.map(([n, o]) => [n, { on: true, parked: false, ...o.level === 0 ? { level: 1 } : {} }])),
    groups: Object.fromEntries(t.map(([n, o]) => [n, { on: true, ...o.level === 0 ? { level: 1 } : {} }]))
  });
}
function au() {
  Ke({ do: "add", lamp: { name: "Sky", kind: "sky", on: true, level: 1, flux: 1e4, color: { mode: "kelvin", kelvin: 6500, tint: 0, rgb: [1, 1, 1], xy: [0.3127, 0.329] }, place: null } });
}
function su() {
  switch (tn.value) {
    case "starting":
      return /* @__PURE__ */ a(me, { tone: "calm", children: "Entering…" });
    case "loading": {
      const e = Kr.value;
      return /* @__PURE__ */ a(me, { tone: "calm", children: [
        "Reading ",
        e?.file ?? z.value?.file ?? "the scene",
        "…",
        e?.bytes ? ` ${R(e.bytes / 1e6, 1)} MB` : "",
        e?.progress != null && /* @__PURE__ */ a("progress", { value: e.progress, max: 1, "aria-label": "Reading" })
      ] });
    }
    case "lost":
      return /* @__PURE__ */ a(me, { tone: "warn", children: [
        "Connection lost, trying again",
        yn.value ? ` (${yn.value} s)` : "…",
        ". Until then nothing can be changed."
      ] });
    case "ended":
      return /* @__PURE__ */ a(me, { tone: "warn", children: [
        "The program has ended. Start it again with ",
        /* @__PURE__ */ a("code", { children: fs() }),
        /* @__PURE__ */ a("button", { onClick: () => void Er(fs()), children: "Copy" }),
        " and this page comes back by itself."
      ] });
    case "denied":
      return /* @__PURE__ */ a(me, { tone: "warn", children: "This link is not valid (any more). Open the one that the program has printed, or ask for a new one." });
    case "renewed":
      return /* @__PURE__ */ a(me, { tone: "warn", children: [
        "New version. ",
        /* @__PURE__ */ a("button", { onClick: () => location.reload(), children: "Reload" })
      ] });
    case "unsaved":
      return /* @__PURE__ */ a(me, { tone: "warn", children: [
        "Edits are not being saved: ",
        xt.value.why ?? "unknown reason",
        ".",
        /* @__PURE__ */ a("button", { onClick: () => Ve.value = "save", children: "Save elsewhere" })
      ] });
    case "broken":
      return /* @__PURE__ */ a(me, { tone: "warn", children: [
        Hn.value,
        " Still showing what was read before."
      ] });
    case "control-lost":
      return /* @__PURE__ */ a(me, { tone: "warn", children: [
        "Control moved to ",
        /* @__PURE__ */ a("em", { children: Dn.value }),
        ". ",
        /* @__PURE__ */ a("button", { onClick: () => q({ do: "edit", what: "take" }), children: "Take it back" })
      ] });
    case "watching":
      return /* @__PURE__ */ a(me, { tone: "calm", children: [
        "You are watching",
        re.value.name ? /* @__PURE__ */ a(X, { children: [
          "; ",
          /* @__PURE__ */ a("em", { children: re.value.name }),
          " edits"
        ] }) : "",
        ".",
        /* @__PURE__ */ a("button", { onClick: () => q({ do: "edit", what: "take" }), children: "Ask for control" })
      ] });
    case "no-lamps":
      return /* @__PURE__ */ a(me, { tone: "calm", children: [
        "This scene has no light. Add: ",
        /* @__PURE__ */ a("button", { onClick: au, children: "sky" }),
        /* @__PURE__ */ a(
          "button",
          {
            onClick: () => {
              Ln.value = "disc";
              Ye("add");
            },
            children: "ceiling lamp"
          }
        ),
        /* @__PURE__ */ a("button", { disabled: true, title: "Photometric files come with a later version", children: "IES file" })
      ] });
    case "all-off":
      return /* @__PURE__ */ a(me, { tone: "warn", children: [
        "All lamps are off.",
        je.value.undo && /* @__PURE__ */ a("button", { onClick: () => Rn.find((e) => e.id === "undo")?.run(), children: "Undo" }),
        /* @__PURE__ */ a("button", { onClick: iu, children: "Turn on" })
      ] });
    case "slow":
      return /* @__PURE__ */ a(me, { tone: "calm", children: [
        "Slow connection.",
        /* @__PURE__ */ a("button", { "aria-pressed": Oe.value, onClick: () => Oe.value = true, children: "Sharper" }),
        /* @__PURE__ */ a("button", { "aria-pressed": !Oe.value, onClick: () => Oe.value = false, children: "Faster" })
      ] });
    default:
      return null;
  }
}
function ms() {
  const e = Ee.value;
  return /* @__PURE__ */ a("div", { class: "banners", "data-scroll": true, children: [
    su(),
    bt.value.length > 0 && /* @__PURE__ */ a(me, { tone: "calm", children: [
      /* @__PURE__ */ a("details", { children: [
        /* @__PURE__ */ a("summary", { children: [
          bt.value.length,
          " edits no longer find what they changed"
        ] }),
        /* @__PURE__ */ a("ul", { children: bt.value.map((t) => /* @__PURE__ */ a("li", { children: t }, t)) })
      ] }),
      /* @__PURE__ */ a("button", { onClick: () => bt.value = [], children: "Good" })
    ] }),
    e.length > 0 && /* @__PURE__ */ a("div", { class: "banner badge", role: "status", children: [
      "Solo: ",
      e.length === 1 ? y.get(e[0])?.name ?? "one lamp" : `${e.length} lamps`,
      /* @__PURE__ */ a("button", { onClick: fo, children: "End solo" })
    ] }),
    /* @__PURE__ */ a("div", { class: "notes", role: "status", "aria-live": "polite", children: Ct.value.map((t) => /* @__PURE__ */ a("div", { class: `banner ${t.tone === "warn" ? "warn" : "calm"}`, children: [
      t.text,
      /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Close", onClick: () => dr(t.id), children: /* @__PURE__ */ a(E, { name: "close" }) })
    ] }, t.id)) })
  ] });
}

// src/views.tsx
function hs() {
  const e = st.all();
  return /* @__PURE__ */ a("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": true, children: [
    /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => B("home"), children: /* @__PURE__ */ a(E, { name: "home" }) }),
    /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => B("frame"), children: /* @__PURE__ */ a(E, { name: "frame" }) }),
    /* @__PURE__ */ a("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => B("back"), children: /* @__PURE__ */ a(E, { name: "back" }) }),
    /* @__PURE__ */ a("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => B("forth"), children: /* @__PURE__ */ a(E, { name: "forth" }) }),
    /* @__PURE__ */ a("span", { class: "divide" }),
    e.map(([t, n], o) => /* @__PURE__ */ a(
      "button",
      {
        class: "saved-view",
        "aria-pressed": Et.value === n.name,
        title: `${n.name ?? "View"} (Alt+${o + 1}); double click to rename, Delete to remove`,
        onClick: () => j(n, n.name ?? "view"),
        onDblClick: () => {
          const r = prompt("Name of the view", n.name ?? "");
          if (r) oe(`Rename the view ${r}`, { views: { [t]: { name: r } } });
        },
        onKeyDown: (r) => {
          if (r.key !== "Delete") return;
          r.stopPropagation();
          oe(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } });
        },
        children: [
          /* @__PURE__ */ a("small", { children: o + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    /* @__PURE__ */ a("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: Cr, children: /* @__PURE__ */ a(E, { name: "plus" }) })
  ] });
}

// src/walkpad.tsx
function vs() {
  const e = ee(null);
  const t = (n) => {
    const o = n.currentTarget;
    n.stopPropagation();
    if (n.type === "pointerdown") o.setPointerCapture(n.pointerId);
    const r = n.type === "pointerup" || n.type === "pointercancel";
    if (!r && !o.hasPointerCapture(n.pointerId)) return;
    const i = o.getBoundingClientRect();
    const s = (u) => Math.max(-1, Math.min(1, u));
    const l = r ? 0 : s((n.clientX - i.left) / (i.width / 2) - 1);
    const d = r ? 0 : s(1 - (n.clientY - i.top) / (i.height / 2));
    e.current?.style.setProperty("transform", `translate(${l * 28}px, ${-d * 28}px)`);
    Fa(d, l);
  };
  return /* @__PURE__ */ a("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: /* @__PURE__ */ a("span", { ref: e }) });
}

// src/view.tsx
var bs = v(null);
function lu(e, t) {
  const n = cs();
  if (!n) return [];
  const [o, r] = [Math.min(e[0], t[0]), Math.max(e[0], t[0])];
  const [i, s] = [Math.min(e[1], t[1]), Math.max(e[1], t[1])];
  return n.filter(({ at: l }) => l[0] >= o && l[0] <= r && l[1] >= i && l[1] <= s).map(({ id: l }) => l);
}
var uu = {
  click(e, t, n) {
    const o = gs(e, t);
    if (U.peek() === null && o) return de(o.kind, o.id, n);
    Do(e, t, (r) => {
      if (r) Ge.value = { point: r.point, normal: r.normal };
      if (U.peek() !== null) return va(r);
      na(r, n);
    });
  },
  menu(e, t) {
    Do(e, t, (n) => {
      if (n) wo(e, t, n);
    });
  },
  double() {
    bo();
  },
  hover(e, t) {
    const n = gs(e, t);
    if (n?.kind === "lamp") ie.value = { kind: "lamp", id: n.id };
    Do(e, t, (o) => {
      Ho.value = o;
      if (o) Ge.value = { point: o.point, normal: o.normal };
      if (o?.lamp != null) ie.value = { kind: "lamp", id: o.lamp };
    });
  },
  unhover() {
    if (ie.peek()) ie.value = null;
  },
  marquee(e, t, n) {
    bs.value = n ? null : { from: e, to: t };
    if (!n) return;
    const o = lu(e, t);
    M.value = o.length ? { kind: "lamp", ids: o } : null;
    U.value = null;
  }
};
function gs(e, t) {
  const n = document.getElementById("overlay");
  let o = null;
  let r = 11;
  for (const i of n?.querySelectorAll(".mark:not([display])") ?? []) {
    const s = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(i.getAttribute("transform") ?? "");
    if (!s) continue;
    const l = Math.hypot(Number(s[1]) - e, Number(s[2]) - t);
    if (l < r) {
      r = l;
      o = { kind: i.dataset.kind, id: Number(i.dataset.id) };
    }
  }
  return o;
}
var cu = {
  aim: "Click what shall be lit. Esc to leave.",
  meter: "Click where the meter shall lie. Esc to leave.",
  grid: "Click two opposite corners of the area. Esc to leave.",
  add: "Click where the lamp shall hang. Esc to leave.",
  marquee: "Drag around the lamps to select. Esc to leave."
};
function ys() {
  const e = ee(null);
  const t = ee(null);
  const n = ee(null);
  Ie(() => {
    pr(t.current);
    const o = ds(n.current);
    const r = us(e.current, uu);
    return () => {
      pr(null);
      o();
      r();
    };
  }, []);
  tr(() => {
    const o = te.value;
    t.current?.setAttribute("data-kind", o?.head.kind ?? "none");
  });
  return /* @__PURE__ */ a("main", { class: "view", "aria-label": "View", children: [
    /* @__PURE__ */ a(
      "div",
      {
        class: U.value ? "stage tooled" : "stage",
        id: "view",
        ref: e,
        tabIndex: 0,
        role: "application",
        "aria-label": `View of ${z.value?.name ?? "the scene"}${Et.value ? `, ${Et.value}` : ""}`,
        "aria-describedby": "view-keys",
        "data-tool": U.value ?? "",
        children: [
          /* @__PURE__ */ a("canvas", { ref: t, width: 640, height: 480, "aria-hidden": "true" }),
          /* @__PURE__ */ a("svg", { id: "overlay", ref: n, "aria-hidden": "true" }),
          /* @__PURE__ */ a(gt, { part: "Gizmo" }),
          /* @__PURE__ */ a(gt, { part: "Compare" }),
          /* @__PURE__ */ a(pu, {})
        ]
      }
    ),
    /* @__PURE__ */ a("p", { id: "view-keys", class: "spoken", children: "Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection, Escape leaves the view." }),
    U.value && /* @__PURE__ */ a("p", { class: "hint", role: "status", children: cu[U.value] }),
    /* @__PURE__ */ a(ms, {}),
    /* @__PURE__ */ a(gt, { part: "Legend" }),
    /* @__PURE__ */ a(du, {}),
    /* @__PURE__ */ a(hs, {}),
    /* @__PURE__ */ a(vs, {}),
    /* @__PURE__ */ a(gt, { part: "What" })
  ] });
}
function pu() {
  const e = bs.value;
  if (!e) return null;
  const { from: t, to: n } = e;
  return /* @__PURE__ */ a("svg", { class: "rubber", "aria-hidden": "true", children: /* @__PURE__ */ a(
    "rect",
    {
      x: Math.min(t[0], n[0]),
      y: Math.min(t[1], n[1]),
      width: Math.abs(n[0] - t[0]),
      height: Math.abs(n[1] - t[1])
    }
  ) });
}
function du() {
  const e = fa.value;
  if (!e) return null;
  return /* @__PURE__ */ a("label", { class: "cut", "data-scroll": true, children: [
    /* @__PURE__ */ a("span", { children: "Cut" }),
    /* @__PURE__ */ a(
      Zt,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: `${R(e.value, 2)} metres`,
        on: (t) => ma(t * e.most)
      }
    ),
    /* @__PURE__ */ a("output", { children: [
      R(e.value, 2),
      " m"
    ] })
  ] });
}

// src/main.tsx
function fu() {
  return /* @__PURE__ */ a(X, { children: [
    /* @__PURE__ */ a(Ta, {}),
    /* @__PURE__ */ a(ts, {}),
    /* @__PURE__ */ a(ys, {}),
    /* @__PURE__ */ a("section", { class: "panel inspector", "aria-label": "Inspector", children: /* @__PURE__ */ a(gt, { part: "Inspector" }) }),
    /* @__PURE__ */ a(ss, {}),
    /* @__PURE__ */ a(rs, {}),
    /* @__PURE__ */ a(gt, { part: "Sheets" })
  ] });
}
var Vt = document.getElementById("desk");
Vt.replaceChildren();
oi(/* @__PURE__ */ a(fu, {}), Vt);
T(() => {
  Vt.dataset.state = tn.value;
  Vt.dataset.line = Q.value;
  Vt.dataset.pen = _e.value === "edit" && re.value.you && !xe.value ? "yes" : "no";
});
T(() => {
  Vt.dataset.panels = Mn.value ? "yes" : "no";
  Vt.dataset.drawer = vt.value ?? "none";
});
T(() => {
  document.documentElement.dataset.theme = ct.value;
  document.documentElement.style.setProperty("--house", String(Bt.value));
});
T(() => {
  if (z.value) document.title = `${z.value.name} – Lampyris`;
});
var _s = 0;
T(() => {
  const [e, t] = Le.value;
  const n = Oe.value ? Math.min(devicePixelRatio, 2) : 1;
  if (Q.value !== "open") return;
  clearTimeout(_s);
  _s = window.setTimeout(() => q({ do: "size", width: Math.round(e * n), height: Math.round(t * n) }), 60);
});
Ua();
Ka();
void Wi();
export {
  bl as DEFAULT_FALSE,
  fn as Entry,
  Fe as Field,
  X as Fragment,
  Be as Gesture,
  E as Icon,
  Li as PRESETS,
  Zt as Range,
  Re as Slice,
  Ot as across,
  B as act,
  Rn as actions,
  C as add,
  dl as addGrid,
  wr as addMeter,
  Ln as adding,
  _r as aim,
  va as applyTool,
  ke as ask,
  sa as back,
  co as before,
  Tn as bounds,
  Hn as broken,
  Se as camera,
  ft as candles,
  Xt as centre,
  F as chosenLamps,
  go as circle,
  fo as clearSolo,
  Vr as closeWhat,
  Ke as command,
  Wt as compareHeld,
  we as comparing,
  Gs as compass,
  Y as computed,
  Wi as connect,
  ga as copyAlong,
  Er as copyText,
  cn as corners,
  he as cross,
  fa as cut,
  Fi as dark,
  kn as deselect,
  R as digits,
  St as display,
  Ue as distance,
  to as dolly,
  W as dot,
  pr as drawOn,
  vt as drawer,
  Sr as each,
  oe as edit,
  re as editor,
  T as effect,
  Xi as endStroke,
  In as exposeBy,
  $t as fade,
  Oe as fine,
  ho as fitted,
  $i as fly,
  We as followed,
  ko as format,
  la as forth,
  Pi as frame,
  bo as frameSelection,
  Vn as free,
  j as go,
  yo as goHome,
  da as goInside,
  pa as goPreset,
  $e as grids,
  K as groups,
  fr as handles,
  Sn as hands,
  fl as hang,
  Ae as hear,
  ae as here,
  xn as highlight,
  je as history,
  Bt as houseLights,
  ie as hovered,
  a as jsx,
  a as jsxs,
  rr as keep,
  il as keepBefore,
  wa as keysOf,
  Cn as lampMarks,
  y as lamps,
  ro as layers,
  it as length,
  Q as line,
  dt as listing,
  Kr as loading,
  Mi as look,
  xe as lookOnly,
  lt as looks,
  bt as lostEdits,
  be as luxText,
  mo as maintenance,
  vn as materials,
  lr as me,
  hn as merge,
  ve as meters,
  Pu as metres,
  wt as middle,
  zs as mix,
  at as moved,
  al as nameOf,
  xa as namedViews,
  J as normal,
  Ct as notes,
  Ec as nudge,
  Ji as onBegin,
  wo as openWhat,
  Ei as orbit,
  Te as output,
  Ti as pan,
  Mn as panels,
  Ca as parse,
  Qe as percent,
  qi as picturesTo,
  pn as pinhole,
  ml as placed,
  hl as positions,
  Vi as preset,
  eo as project,
  Ut as rate,
  Tu as ray,
  Zs as readHead,
  Oi as receivePatch,
  Di as receiveState,
  Ft as releaseUpTo,
  ba as removeLamps,
  yn as retryIn,
  _e as role,
  dn as same,
  xt as saved,
  G as say,
  x as scale,
  z as scene,
  de as select,
  na as selectHit,
  kr as selectNext,
  ta as selectRange,
  M as selection,
  q as send,
  ma as setCut,
  ao as settle,
  Ve as sheet,
  ze as show,
  te as shown,
  v as signal,
  ia as singleKeys,
  Yt as slide,
  Wl as slow,
  Gi as snapshot,
  Ee as solo,
  hr as soloLamps,
  oa as soloSelection,
  pl as spacing,
  Ge as spot,
  Or as stage,
  Ye as startTool,
  tn as state,
  ge as status,
  uo as step,
  mr as stepSelection,
  $r as storeLook,
  Cr as storeView,
  ca as stride,
  Qi as stroke,
  H as sub,
  Dn as taken,
  ct as theme,
  pe as things,
  Je as three,
  Pe as titleOf,
  Gt as toFrame,
  Mr as toggleFalse,
  ea as toggleWipe,
  U as tool,
  zt as travel,
  Qn as turn,
  vo as turnHead,
  dr as unsay,
  se as untracked,
  Xe as up,
  Ns as useComputed,
  Ie as useEffect,
  ee as useRef,
  rt as useSignal,
  tr as useSignalEffect,
  yl as viewFromLamp,
  Et as viewName,
  Tt as viewPinhole,
  Le as viewSize,
  st as views,
  Ci as walk,
  pt as walking,
  _a as wantLevel,
  Pt as what,
  ue as whyNot,
  ka as whyNotTo,
  tc as wipeAt,
  no as zoom
};
