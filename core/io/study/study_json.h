#pragma once

#include "core/study/study.h"

#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/**
 * A study file (`"format": "bergwatch-study"`): the whole spec and the outcomes flown so far, so
 * that it can be carried on, merged with other shards, and its figures made again. No times and no
 * machine in it: the same study gives the same bytes.
 */
[[nodiscard]] std::string studyToJson(const Study& study);
/** Errors as for `scenarioFromJson`. */
[[nodiscard]] Study studyFromJson(std::string_view text, const std::string& subject,
                                  const std::stop_token& stop = {});
/** Of a study file, or of the one that a report keeps (`studyReportHtml`). */
[[nodiscard]] Study loadStudy(const std::string& path, const std::stop_token& stop = {});
/** Throws `Error{FileTooLarge}` when the file of the whole study could not be read back. */
void saveStudy(const Study& study, const std::string& path);

} // namespace berg
