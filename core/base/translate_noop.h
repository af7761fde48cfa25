#pragma once

// Marks texts for lupdate, which recognises the macro's name. The definition equals Qt's token by
// token, so both headers may be included; it needs no Qt.
#define QT_TRANSLATE_NOOP(scope, x) x
#define QT_TRANSLATE_N_NOOP(scope, x) x // with a count, %n
