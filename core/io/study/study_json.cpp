#include "core/io/study/study_json.h"

#include "core/io/files/run_keyframe.h"
#include "core/io/files/scenario_parts.h"
#include "core/io/study/study_report.h"
#include "core/io/text/atomic_file.h"

#include <cmath>

namespace berg {

namespace {

constexpr std::string_view kFormat = "bergwatch-study";
constexpr WholeLimits kCount{.low = 0, .high = kLargestCount};
constexpr std::size_t kOutcomeNumbers = 5;
/**
 * Bytes of an outcome in practice, at most: two numbers of 18 digits, three counts, punctuation.
 */
constexpr std::size_t kOutcomeBytes = 56;

std::string fieldText(const FieldSpec& field)
{
    JsonObject object;
    object.add("icebergs", field.icebergs);
    object.add("size_m", field.size_m);
    object.add("speed_max_mps", field.speedMax_mps);
    object.add("sigma_min_m2", field.sigmaMin_m2);
    object.add("sigma_max_m2", field.sigmaMax_m2);
    object.add("q_m2ps", field.q_m2ps);
    if (field.regime != FieldRegime::Published)
        object.add("regime", nameOf(kFieldRegimeNames, field.regime));
    return object.inLine();
}

/** Appends `[zeta_m2s, visits, replans, flown_m, stuck]`, or `null` for a mission not flown. */
void append(std::string& text, const std::optional<MissionOutcome>& outcome)
{
    if (!outcome) {
        text += "null";
        return;
    }
    const Metrics& metrics = outcome->metrics;
    text += '[' + jsonText(metrics.zeta_m2s) + ',' + jsonText(metrics.visits) + ',' +
            jsonText(metrics.replans) + ',' + jsonText(metrics.flown_m) +
            (outcome->stuck ? ",1]" : ",0]");
}

/** JSON array with a line for each case: its outcomes by setting, or `null` if none is flown. */
std::string outcomesText(const Study& study)
{
    const std::size_t settings = settingsOf(study.spec).size();
    std::vector<std::string> lines;
    for (std::size_t first = 0; first < study.outcomes.size(); first += settings) {
        bool any = false;
        std::string line;
        for (std::size_t i = first; i < first + settings; ++i) {
            line += i == first ? '[' : ',';
            append(line, study.outcomes[i]);
            any = any || study.outcomes[i];
        }
        lines.push_back(any ? line + ']' : "null");
    }
    return jsonLines(lines, 1);
}

FieldSpec readField(const Json& value, const std::string& path, Faults& faults)
{
    ObjectReader object(value, path, faults);
    FieldSpec field;
    field.icebergs = asInt(object.whole("icebergs", field.icebergs, kCount));
    field.size_m = object.point("size_m", field.size_m);
    field.speedMax_mps = object.number("speed_max_mps", field.speedMax_mps);
    field.sigmaMin_m2 = object.number("sigma_min_m2", field.sigmaMin_m2);
    field.sigmaMax_m2 = object.number("sigma_max_m2", field.sigmaMax_m2);
    field.q_m2ps = object.number("q_m2ps", field.q_m2ps);
    field.regime = object.choice("regime", field.regime, kFieldRegimeNames);
    return field;
}

std::vector<double> readTaus(ObjectReader& study)
{
    return readEach(study, "taus", [&](const Json& value, const std::string& path) {
        return numberOf(value, path, study.faults()).value_or(0);
    });
}

std::vector<PolicyKind> readPolicies(ObjectReader& study)
{
    std::vector<PolicyKind> policies;
    const Json* list = study.neededArray("policies");
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        const Json& name = (*list)[i];
        const auto policy = name.is_string()
                                ? valueOf(kPolicyNames, name.get_ref<const std::string&>())
                                : std::nullopt;
        if (!policy)
            study.faults().add(entryPath(study.path("policies"), i),
                               {IssueId::NotOneOf, {allowedNames(kPolicyNames)}});
        policies.push_back(policy.value_or(PolicyKind::Visitation));
    }
    return policies;
}

std::vector<Scenario> readScenarios(ObjectReader& study)
{
    return readEach(study, "scenarios", [&](const Json& value, const std::string& path) {
        ObjectReader scenario(value, path, study.faults());
        return readScenario(scenario);
    });
}

StudySpec readSpec(ObjectReader& study)
{
    constexpr WholeLimits kSeeds{.low = 0, .high = kLargestSeed};
    StudySpec spec;
    spec.name = study.text("name");
    spec.taus = readTaus(study);
    spec.policies = readPolicies(study);
    spec.runs = asInt(study.whole("runs", spec.runs, kCount));
    spec.random = asInt(study.whole("random", spec.random, kCount));
    spec.firstSeed = study.whole("first_seed", spec.firstSeed, kSeeds);
    if (const Json* value = study.find("field"))
        spec.field = readField(*value, study.path("field"), study.faults());
    spec.scenarios = readScenarios(study);
    if (study.faults().empty())
        for (Issue& issue : validate(spec))
            study.faults().add(std::move(issue));
    return spec;
}

/** Reads one `[zeta_m2s, visits, replans, flown_m, stuck]`; its path is made only for a fault. */
class OutcomeReader
{
public:
    OutcomeReader(const Json& value, std::function<std::string()> path, Faults& faults)
        : m_value(value), m_path(std::move(path)), m_faults(faults)
    {
    }

    [[nodiscard]] std::optional<MissionOutcome> read() const
    {
        if (m_value.is_null())
            return std::nullopt;
        if (!m_value.is_array() || m_value.size() != kOutcomeNumbers) {
            m_faults.add(m_path(),
                         {IssueId::EntryCount, {countOf(kOutcomeNumbers), entriesOf(m_value)}});
            return std::nullopt;
        }
        return MissionOutcome{.metrics = {.zeta_m2s = amount(0),
                                          .visits = whole(1, kLargestCount),
                                          .replans = whole(2, kLargestCount),
                                          .flown_m = amount(3)},
                              .stuck = whole(4, 1) == 1};
    }

private:
    [[nodiscard]] double amount(std::size_t i) const
    {
        const double number = m_value[i].is_number() ? m_value[i].get<double>() : -1;
        if (number >= 0 && number <= kAmount.high)
            return number;
        return numberOf(m_value[i], entryPath(m_path(), i), m_faults, kAmount).value_or(0);
    }

    [[nodiscard]] int whole(std::size_t i, std::int64_t most) const
    {
        const double number = m_value[i].is_number() ? m_value[i].get<double>() : -1;
        if (number >= 0 && number <= static_cast<double>(most) && number == std::floor(number))
            return static_cast<int>(number);
        const WholeLimits limits{.low = 0, .high = most};
        return asInt(wholeOf(m_value[i], entryPath(m_path(), i), m_faults, limits).value_or(0));
    }

    const Json& m_value;
    std::function<std::string()> m_path;
    Faults& m_faults;
};

/** Reads the outcomes of one case and appends them to the study's. */
void readCase(const Json& value, std::size_t settings, const std::string& path, Study& study,
              Faults& faults)
{
    if (value.is_null()) {
        study.outcomes.resize(study.outcomes.size() + settings);
        return;
    }
    if (!value.is_array() || value.size() != settings) {
        faults.add(path, {IssueId::EntryCount, {countOf(settings), entriesOf(value)}});
        return;
    }
    for (std::size_t s = 0; s < settings; ++s)
        study.outcomes.push_back(OutcomeReader(
                                     value[s], [&] { return entryPath(path, s); }, faults)
                                     .read());
}

/** Reads the outcomes of a study whose spec has no faults. */
void readOutcomes(ObjectReader& object, Study& study)
{
    const std::size_t cases = caseCount(study.spec);
    const std::size_t settings = settingsOf(study.spec).size();
    const Json* list = object.array("outcomes");
    if (list == nullptr || list->empty())
        return;
    if (list->size() != cases) {
        object.faults().add(object.path("outcomes"),
                            {IssueId::EntryCount, {countOf(cases), countOf(list->size())}});
        return;
    }
    object.faults().take(cases * settings * sizeof(study.outcomes.front()));
    study.outcomes.reserve(cases * settings);
    for (std::size_t c = 0; c < cases; ++c)
        readCase((*list)[c], settings, entryPath(object.path("outcomes"), c), study,
                 object.faults());
}

} // namespace

std::string studyToJson(const Study& study)
{
    const StudySpec& spec = study.spec;
    const auto text = [](const Scenario& scenario) { return scenarioText(scenario, 2); };
    const auto name = [](PolicyKind policy) { return nameOf(kPolicyNames, policy); };
    JsonObject object;
    object.add("format", kFormat);
    object.add("version", 1);
    object.add("name", spec.name);
    object.addText("taus", jsonArrayOf(spec.taus));
    object.addText("policies", jsonArrayOf(textsOf(spec.policies, name)));
    object.add("runs", spec.runs);
    object.add("random", spec.random);
    object.add("first_seed", spec.firstSeed);
    object.addText("field", fieldText(spec.field));
    object.addText("scenarios", jsonLines(textsOf(spec.scenarios, text), 1));
    object.addText("outcomes", outcomesText(study));
    return object.inLines(0) + '\n';
}

Study studyFromJson(std::string_view text, const std::string& subject, const std::stop_token& stop)
{
    ReadBudget budget(subject, text.size(), stop);
    ParsedJson parsed = parseJson(text, budget);
    requireFormat(parsed, kFormat, subject);
    ObjectReader object(parsed.root, "", parsed.faults);
    Study study{.spec = readSpec(object)};
    if (parsed.faults.empty())
        readOutcomes(object, study);
    parsed.faults.throwIfAny(subject);
    return study;
}

Study loadStudy(const std::string& path, const std::stop_token& stop)
{
    const std::string text = readFile(path, stop);
    return studyFromJson(isReport(text) ? studyOfReport(text, path) : text, path, stop);
}

void saveStudy(const Study& study, const std::string& path)
{
    const std::string text = studyToJson(study);
    const std::size_t missing = missionCount(study.spec) - flownCount(study);
    if (text.size() + missing * kOutcomeBytes > kLargestFile)
        throw Error(ErrorCode::FileTooLarge, path,
                    {IssueId::StudyTooLarge, {countOf(kLargestFile >> 20U)}});
    writeFileAtomically(path, text);
}

} // namespace berg
