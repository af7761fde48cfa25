#pragma once

// Marks words for lupdate, which knows them by this name; what the program does with them is its
// own affair. Without Qt, and token by token what Qt says, so that both may be included.
#define QT_TRANSLATE_NOOP(scope, x) x
