#pragma once

#include "core/study/study.h"

#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/**
 * Returns the text of a study file (`"format": "bergwatch-study"`): the whole spec and the outcomes
 * flown so far, so that the study can be continued, merged with other shards and summarised again.
 * It contains neither times nor machine names: the same study gives the same bytes.
 */
[[nodiscard]] std::string studyToJson(const Study& study);
/** Reads a study file. Throws as `scenarioFromJson`. */
[[nodiscard]] Study studyFromJson(std::string_view text, const std::string& subject,
                                  const std::stop_token& stop = {});
/**
 * Reads a study file, or the study in a report (`studyReportHtml`); throws as `readFile`,
 * `studyOfReport` and `studyFromJson`.
 */
[[nodiscard]] Study loadStudy(const std::string& path, const std::stop_token& stop = {});
/**
 * Writes a study file; throws as `writeFileAtomically`, and `Error{FileTooLarge}` if the file of
 * the complete study would be too large to read back.
 */
void saveStudy(const Study& study, const std::string& path);

} // namespace berg
