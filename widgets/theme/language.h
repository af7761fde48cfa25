#pragma once

#include <QString>

#include <optional>

namespace berg {

/**
 * Installs translations (ours and Qt's) and the default locale of a language such as "nb", or of
 * the system's language. Languages without translation fall back to English, which has a
 * translation for plural forms.
 */
void installLanguage(const std::optional<QString>& language);

} // namespace berg
