#pragma once

#include "core/base/random.h"
#include "core/coverage/coverage_model.h"

namespace berg {

/** Random changes of plans, in the proportions that the search was tuned with. */
class CoverageMoves
{
public:
    /**
     * Prepares changes for a model, which is not kept and must have at least one iceberg, with legs
     * to those allowed; an empty list allows all.
     */
    CoverageMoves(const CoverageModel& model, const Random& random,
                  const std::vector<bool>& allowed = {});

    /**
     * Changes a plan, which must have at least one leg. The change is a new offset, a leg added,
     * removed, replaced, moved or exchanged, or a reversed stretch of the plan; most changes are
     * near the front. If keeping icebergs in view pays, the duration of a stay or a hold may
     * change, too. Returns the index of the first leg that may differ.
     */
    std::size_t change(CoveragePlan& plan);

    /** Returns a uniform number in [0, 1) from the random stream of the changes. */
    [[nodiscard]] double uniform() { return m_random.uniform(); }

private:
    std::size_t changeOne(CoveragePlan& plan, std::uint64_t dice);
    std::size_t changeTwo(CoveragePlan& plan, std::uint64_t dice);
    std::size_t changeHold(CoveragePlan& plan);
    void changeLine(CoverageLeg& leg);
    void vary(CoverageLeg& hold);
    [[nodiscard]] CoverageLeg anyHold();
    /** Returns a number below `count`, small ones the more often, the higher the power. */
    [[nodiscard]] std::size_t drawn(std::size_t count, double power);
    [[nodiscard]] std::size_t placeNear(std::size_t place, std::size_t count);
    /** Returns a leg to any place, most often to a neighbour of the place of the leg before. */
    [[nodiscard]] CoverageLeg anyLeg(const CoveragePlan& plan, std::size_t place);
    /** Returns all other allowed icebergs, nearest first. */
    [[nodiscard]] const std::vector<ModelPlace>& neighbours(ModelPlace iceberg);
    [[nodiscard]] double anyOffset_m();
    [[nodiscard]] double nearOffset_m(double offset_m);

    std::vector<bool> m_allowed;
    std::vector<Point> m_places_m; ///< Places of the icebergs at the start of the prediction.
    /** For each iceberg; empty until they are needed. */
    std::vector<std::vector<ModelPlace>> m_neighbours;
    double m_edge_m;
    bool m_paysForSamples;
    Random m_random;
};

} // namespace berg
