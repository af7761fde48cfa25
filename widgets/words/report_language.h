#pragma once

#include "core/io/text/report_words.h"

namespace berg {

/** Pages for people in the language of the window; may be asked from any thread. */
[[nodiscard]] ReportWords reportLanguage();

} // namespace berg
