#pragma once

#include "core/base/random.h"
#include "core/coverage/coverage_model.h"

namespace berg {

/** Random changes of plans, in the mix that the search was tuned with. */
class CoverageMoves
{
public:
    /** Of plans for a model that has an iceberg at least, with legs to these: empty, all. */
    CoverageMoves(const CoverageModel& model, const Random& random,
                  const std::vector<bool>& allowed = {});

    /**
     * Changes a plan that has legs: an offset, or a leg added, removed, replaced, moved or
     * exchanged, or a stretch of the plan turned round; mostly near its front. Where looks pay also
     * how long a leg stays, and holds. Returns the first place that may differ.
     */
    std::size_t change(CoveragePlan& plan);

    /** Uniform in [0, 1), from the same stream. */
    [[nodiscard]] double uniform() { return m_random.uniform(); }

private:
    std::size_t changeOne(CoveragePlan& plan, std::uint64_t dice);
    std::size_t changeTwo(CoveragePlan& plan, std::uint64_t dice);
    std::size_t changeHold(CoveragePlan& plan);
    void changeLine(CoverageLeg& leg);
    void vary(CoverageLeg& hold);
    [[nodiscard]] CoverageLeg anyHold();
    /** Below `count`; small ones the more often, the higher the power. */
    [[nodiscard]] std::size_t drawn(std::size_t count, double power);
    [[nodiscard]] std::size_t placeNear(std::size_t place, std::size_t count);
    /** To one of all icebergs, rather to a neighbour of the one that the leg before goes to. */
    [[nodiscard]] CoverageLeg anyLeg(const CoveragePlan& plan, std::size_t place);
    [[nodiscard]] double anyOffset_m();
    [[nodiscard]] double nearOffset_m(double offset_m);

    std::vector<std::vector<int>>
        m_neighbours; ///< of each iceberg all allowed others, nearest first
    double m_edge_m;
    bool m_paysForLooks;
    Random m_random;
};

} // namespace berg
