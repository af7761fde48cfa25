#pragma once

#include "core/io/words/report_words.h"

namespace berg {

/** Returns the words of reports in the language of the window. Thread: any. */
[[nodiscard]] ReportWords reportLanguage();

} // namespace berg
