#pragma once

#include "widgets/study/study_runner.h"
#include "widgets/tables/cell_model.h"
#include "widgets/theme/theme.h"

#include <QLocale>

#include <optional>

namespace berg {

/** Scenario and run of a case of a study. */
struct StudyCase
{
    QString scenario{}; ///< name of the scenario, or the seed it was drawn from
    int run = 0;
    std::int64_t seed = 0; ///< seed of the noise
};
/** Returns scenario and run of a case. */
[[nodiscard]] StudyCase studyCase(const StudySpec& spec, std::size_t caseIndex);

/**
 * Returns the settings of a study and their results, by row; the last row is the best tau of each
 * case in hindsight, if known. Without a result there are no rows.
 */
[[nodiscard]] CellSheet studySettings(const StudyPointer& result, const Theme& theme,
                                      const QLocale& locale);

/**
 * Returns the cases of one setting: zeta of each and its difference from the reference. Without
 * both arguments there are no rows.
 */
[[nodiscard]] CellSheet studyCases(const StudyPointer& result, std::optional<std::size_t> setting,
                                   const QLocale& locale);

} // namespace berg
