#pragma once

#include <QString>

namespace berg {

/**
 * Installs translations (ours and Qt's) and the default locale of a language such as "nb"; an empty
 * name means the system's language. Languages without translation fall back to English, which has a
 * translation for plural forms.
 */
void installLanguage(const QString& language);

} // namespace berg
