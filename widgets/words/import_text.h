#pragma once

#include "core/io/import/scenario/import_scenario.h"

#include <QLocale>

namespace berg {

// Texts about an import, for the user.

/** Returns the text of a note. */
[[nodiscard]] QString importNoteSentence(ImportNote note);
/** Returns the source of the velocity and its age: "both, 1 h 40 min". */
[[nodiscard]] QString velocitySourceText(const ImportedIceberg& iceberg, const QLocale& locale);
/** Returns the outcome as a word. */
[[nodiscard]] QString importOutcomeWord(ImportOutcome outcome);
/** Returns the name of a field of a sighting. */
[[nodiscard]] QString sightingFieldName(SightingField field);
/** Returns the name of a format by its id in `importFormats`, with its origin. */
[[nodiscard]] QString importFormatName(std::string_view id);

/** Returns "12 new, 3 updated, 7 rows rejected". Zero counts are omitted. */
[[nodiscard]] QString importSummary(const ImportResult& result);

/**
 * Returns what happens to the UAVs, area and asset of the file: imported items on one line, items
 * left out on another; empty if the file has none.
 */
[[nodiscard]] QString sceneSummary(const std::vector<SceneFinding>& findings);

/**
 * Returns advice for sightings beyond the reach of the plane; empty if there are none. `isInto` is
 * true for an import into the present scenario.
 */
[[nodiscard]] QString farSightingsText(const ImportResult& result, bool isInto);

/** Returns a note that a date was read month first. */
[[nodiscard]] QString guessedDateText(const std::string& date, std::size_t line);

/** Returns why nothing can be imported: file, sentence, then the core's findings. */
[[nodiscard]] QString importErrorReport(const Error& error);

/** Returns the time in UTC: "2024-05-01 06:00". */
[[nodiscard]] QString utcTimeText(UtcTime time);

/** Returns an age: "2 d 4 h", "3 h 10 min", "7 min". */
[[nodiscard]] QString ageText(double age_s, const QLocale& locale);

} // namespace berg
