#pragma once

#include "core/io/import/import_scenario.h"

#include <QLocale>

namespace berg {

// What an import says, in the user's words.

[[nodiscard]] QString importNoteSentence(ImportNote note);
[[nodiscard]] QString importOutcomeWord(ImportOutcome outcome);
[[nodiscard]] QString sightingFieldName(SightingField field);
/** Where files of this format come from; `id` of `importFormats`. */
[[nodiscard]] QString importFormatName(std::string_view id);

/** "12 new, 3 updated, 7 rows rejected": what there is none of is not told. */
[[nodiscard]] QString importSummary(const ImportResult& result);

/**
 * What becomes of the UAVs, area and asset of the file: what is taken over on a line, what is left
 * out on another; empty when it tells of none.
 */
[[nodiscard]] QString sceneSummary(const std::vector<SceneFinding>& findings);

/** That a date was read month first, and how to write one that has one reading. */
[[nodiscard]] QString guessedDateText(const std::string& date, std::size_t line);

/** Why nothing can be imported: file, sentence, then the core's own findings. */
[[nodiscard]] QString importErrorReport(const Error& error);

/** "2024-05-01 06:00", UTC. */
[[nodiscard]] QString utcTimeText(UtcTime time);

/** "2 d 4 h", "3 h 10 min", "7 min": how long ago. */
[[nodiscard]] QString ageText(double age_s, const QLocale& locale);

} // namespace berg
