#include "core/io/files/certificate_json.h"

#include "core/base/number_text.h"
#include "core/io/text/json_writer.h"
#include "core/plan/proof/layered_graph.h"
#include "core/plan/solve/names.h"

#include <cmath>
#include <cstdio>

namespace berg {

namespace {

std::string numbers(const Eigen::VectorXd& values)
{
    return jsonArrayOf(std::vector<double>(values.begin(), values.end()));
}

std::string matrixText(const Eigen::MatrixXd& distance_m)
{
    std::vector<std::string> rows;
    for (Eigen::Index i = 0; i < distance_m.rows(); ++i) {
        Eigen::VectorXd row = distance_m.row(i).transpose();
        row(i) = 0; // the diagonal of a problem may hold anything
        rows.push_back(numbers(row));
    }
    return jsonLines(rows, 2);
}

/** Hexadecimal text of a set in which bit i is iceberg i. */
std::string setText(const NodeSet& set)
{
    std::array<char, 40> text{};
    if (set.words[1] != 0)
        std::snprintf(text.data(), text.size(), "%llx%016llx",
                      static_cast<unsigned long long>(set.words[1]),
                      static_cast<unsigned long long>(set.words[0]));
    else
        std::snprintf(text.data(), text.size(), "%llx",
                      static_cast<unsigned long long>(set.words[0]));
    return text.data();
}

std::string stepText(const ProofStep& step)
{
    JsonObject object;
    object.addText("lambda", numbers(step.lambda));
    if (step.sets) {
        const auto n = static_cast<int>(step.lambda.size()) - 1;
        std::vector<std::string> bands;
        for (int band = 1; band <= n; ++band) {
            std::vector<std::string> sets;
            for (const NodeIndex i : icebergNodes(n))
                sets.push_back(setText(step.sets->at(band, i)));
            bands.push_back(jsonArrayOf(sets));
        }
        object.addText("sets", jsonLines(bands, 4));
    }
    return object.inLine();
}

constexpr std::array<Named<ProofMethod>, 3> kMethodNames{{
    {ProofMethod::Enumeration, "enumeration"},
    {ProofMethod::Sorting, "sorting"},
    {ProofMethod::Relaxation, "relaxation"},
}};

/** Sentence that states what the proof shows, for a person who opens the file. */
std::string claimOf(const Proof& proof)
{
    constexpr double kOptimal = 1e-8; // leaves room for rounding
    const double gap = proof.cost > 0 ? (proof.cost - proof.bound) / proof.cost : 0.0;
    if (gap <= kOptimal)
        return "the orders are optimal";
    // The gap is rounded up and leaves room for a reader who adds the cost in another order: a
    // claim is never below the gap.
    constexpr double kRounding = 1e-9;
    constexpr int kDigits = 3;
    const double percent = 100 * gap + kRounding;
    const int decimals = decimalsFor(percent, kDigits);
    const double unit = std::pow(10.0, -decimals);
    return "the orders are within " + fixedText(std::ceil(percent / unit) * unit, decimals) +
           " % of optimal";
}

std::string orderText(const VisitOrder& order)
{
    return jsonArrayOf(numbersOf(order));
}

std::string proofText(const Proof& proof)
{
    JsonObject object;
    object.add("claim", claimOf(proof));
    object.add("mu", proof.mu);
    object.addText("orders", jsonArray(textsOf(proof.orders, orderText)));
    object.add("cost", proof.cost);
    object.add("bound", proof.bound);
    object.add("method", nameOf(kMethodNames, proof.method));
    if (!proof.rises.empty())
        object.addText("rises", jsonArrayOf(proof.rises));
    if (!proof.steps.empty())
        object.addText("steps", jsonLines(textsOf(proof.steps, stepText), 3));
    return object.inLines(2);
}

} // namespace

std::string certificateJson(const Certificate& certificate)
{
    const FleetProblem& problem = certificate.problem;
    JsonObject object;
    object.add("format", "bergwatch-certificate");
    object.add("version", 1);
    object.add("criterion", nameOf(kCriterionNames, problem.criterion));
    object.add("route", nameOf(kRouteNames, problem.route));
    object.addText("sigma", jsonArrayOf(problem.sigma_m2));
    object.addText("distance_m", jsonLines(textsOf(problem.distance_m, matrixText), 1));
    if (!problem.allowed.empty())
        object.addText("allowed", jsonLines(textsOf(problem.allowed, jsonArrayOf<bool>), 1));
    object.addText("proofs", jsonLines(textsOf(certificate.proofs, proofText), 1));
    return object.inLines(0) + '\n';
}

} // namespace berg
