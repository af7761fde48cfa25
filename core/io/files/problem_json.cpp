#include "core/io/files/problem_json.h"

#include "core/checks/scenario_warnings.h"
#include "core/io/files/scenario_parts.h"
#include "core/io/files/tsplib.h"
#include "core/io/text/atomic_file.h"
#include "core/plan/problem/tuning.h"

namespace berg {

namespace {

constexpr std::string_view kFormat = "bergwatch-problem";

constexpr Limits kProblemNumber{.low = 0, .high = kLargestProblemNumber};

std::vector<double> readSigmas(ObjectReader& object)
{
    std::vector<double> sigma_m2;
    const Json* list = object.neededArray("sigma");
    if (list == nullptr)
        return sigma_m2;
    const std::string path = object.path("sigma");
    if (list->empty() || list->size() > kMostProblemNodes) {
        object.faults().add(
            path, {IssueId::EntryRange, {1, countOf(kMostProblemNodes), countOf(list->size())}});
        return sigma_m2;
    }
    for (std::size_t i = 0; i < list->size(); ++i)
        sigma_m2.push_back(
            numberOf((*list)[i], entryPath(path, i), object.faults(), kProblemNumber).value_or(0));
    if (sigma_m2[0] != 0)
        object.faults().add(entryPath(path, 0), {IssueId::SigmaOfUav});
    return sigma_m2;
}

/** Returns false after adding a fault if `list` is not an array of `size` entries. */
bool hasSize(const Json& list, std::size_t size, const std::string& path, Faults& faults)
{
    if (list.is_array() && list.size() == size)
        return true;
    faults.add(path, {IssueId::EntryCount, {countOf(size), entriesOf(list)}});
    return false;
}

Eigen::MatrixXd readDistances(const Json& rows, std::size_t nodes, ObjectReader& object)
{
    const auto n = static_cast<Eigen::Index>(nodes);
    Eigen::MatrixXd distance_m = Eigen::MatrixXd::Zero(n, n);
    const std::string path = object.path("distance_m");
    if (!hasSize(rows, nodes, path, object.faults()))
        return distance_m;
    for (std::size_t i = 0; i < nodes; ++i) {
        const std::string rowPath = entryPath(path, i);
        if (!hasSize(rows[i], nodes, rowPath, object.faults()))
            continue;
        for (std::size_t j = 0; j < nodes; ++j)
            if (i != j) // the diagonal is not read, whatever it holds
                distance_m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                    numberOf(rows[i][j], entryPath(rowPath, j), object.faults(), kProblemNumber)
                        .value_or(0);
    }
    return distance_m;
}

Eigen::MatrixXd readPositions(const Json& rows, std::size_t nodes, ObjectReader& object)
{
    constexpr Limits kCoordinate{.low = -kLargestProblemNumber, .high = kLargestProblemNumber};
    Eigen::MatrixX2d position_m = Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(nodes), 2);
    const std::string path = object.path("position_m");
    if (!hasSize(rows, nodes, path, object.faults()))
        return euclideanDistances(position_m);
    for (std::size_t i = 0; i < nodes; ++i) {
        const std::string rowPath = entryPath(path, i);
        const std::optional<Point> point = pointOf(rows[i], rowPath, object.faults());
        if (!point)
            continue;
        for (const Eigen::Index axis : {0, 1})
            if (std::optional<IssueReason> fault = outOfLimits((*point)[axis], kCoordinate))
                object.faults().add(entryPath(rowPath, static_cast<std::size_t>(axis)),
                                    std::move(*fault));
        position_m.row(static_cast<Eigen::Index>(i)) = point->transpose();
    }
    return euclideanDistances(position_m);
}

/** Reads the distances from `distance_m` or `position_m`; exactly one of them must be given. */
Eigen::MatrixXd readGeometry(ObjectReader& object, std::size_t nodes)
{
    const Json* distances = object.find("distance_m");
    const Json* positions = object.find("position_m");
    if (distances != nullptr && positions != nullptr)
        object.faults().add(object.path("position_m"),
                            {IssueId::NotBeside, {FieldPath{"distance_m"}}});
    if (distances == nullptr && positions == nullptr)
        object.faults().add(object.path("distance_m"),
                            {IssueId::MissingBoth, {FieldPath{"position_m"}}});
    if (nodes > 0 && distances != nullptr)
        return readDistances(*distances, nodes, object);
    if (nodes > 0 && positions != nullptr)
        return readPositions(*positions, nodes, object);
    return {};
}

} // namespace

ProblemFile problemFromJson(std::string_view text, const std::string& subject,
                            const std::stop_token& stop)
{
    ReadBudget budget(subject, text.size(), stop);
    ParsedJson parsed = parseJson(text, budget);
    requireFormat(parsed, kFormat, subject);
    ObjectReader object(parsed.root, "", parsed.faults);
    checkFormat(object, kFormat);

    ProblemFile file;
    file.problem.sigma_m2 = readSigmas(object);
    file.problem.distance_m = readGeometry(object, file.problem.sigma_m2.size());
    file.problem.route = object.choice("route", Route::Open, kRouteNames);
    const std::optional<double> tau = object.optionalNumber("tau", limits::kTau);
    const std::optional<double> mu = object.optionalNumber("mu", kProblemNumber);
    if (tau && mu)
        parsed.faults.add("tau", {IssueId::NotBeside, {FieldPath{"mu"}}});
    parsed.faults.throwIfAny(subject);
    if (std::optional<Issue> hint = unknownMembers({}, object.unknown()))
        file.hints.push_back(std::move(*hint));

    if (mu) {
        file.problem.mu = *mu;
    } else {
        file.tau = tau.value_or(1);
        file.problem.mu = tuningWeight(file.problem, *file.tau).mu;
    }
    // Every number is within its limits by now, but the mu that results from tau may not be valid
    // where distances are close to zero.
    if (std::vector<Issue> issues = validate(file.problem); !issues.empty())
        throw Error(ErrorCode::InvalidInput, subject, std::move(issues));
    return file;
}

ProblemFile problemFromText(std::string_view text, const std::string& subject,
                            const std::stop_token& stop)
{
    return isTsplib(text, subject) ? problemFromTsplib(text, subject, stop)
                                   : problemFromJson(text, subject, stop);
}

ProblemFile loadProblem(const std::string& path)
{
    return problemFromText(readFile(path), path);
}

} // namespace berg
