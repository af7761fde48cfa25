#pragma once

#include <QString>

namespace berg {

/**
 * Translators of one language ("nb"), its own words and Qt's, and its locale; empty: the system's
 * language. Languages we have no words in speak English, which has a translation of its own for
 * plural forms.
 */
void installLanguage(const QString& language);

} // namespace berg
