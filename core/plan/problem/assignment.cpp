#include "core/plan/problem/assignment.h"

#include "core/base/error.h"

#include <limits>

namespace berg {

namespace {

/** Agents and places count from 1; 0 means none. */
class AssignmentSearch
{
public:
    AssignmentSearch(const Eigen::MatrixXd& cost, const std::function<bool()>& isStopped)
        : m_cost(cost)
        , m_isStopped(isStopped)
        , m_agentMultiplier(at(cost.cols()) + 1, 0.0)
        , m_placeMultiplier(at(cost.rows()) + 1, 0.0)
        , m_agentAt(at(cost.rows()) + 1, 0)
    {
    }

    /**
     * Assigns an agent to a place, on the shortest path of exchanges to a free one. Returns false
     * if stopped.
     */
    [[nodiscard]] bool add(Eigen::Index agent)
    {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        std::vector<double> least(m_agentAt.size(), kInfinity);
        std::vector<std::size_t> before(m_agentAt.size(), 0);
        std::vector<bool> done(m_agentAt.size(), false);
        m_agentAt[0] = agent;
        std::size_t place = 0;
        while (m_agentAt[place] != 0) {
            if (m_isStopped && m_isStopped())
                return false;
            done[place] = true;
            const Eigen::Index from = m_agentAt[place];
            const double* const costs = m_cost.col(from - 1).data();
            double step = kInfinity;
            std::size_t nearest = 0;
            for (std::size_t k = 1; k < m_agentAt.size(); ++k) {
                if (done[k])
                    continue;
                const double reduced =
                    costs[k - 1] - m_agentMultiplier[at(from)] - m_placeMultiplier[k];
                if (reduced < least[k]) {
                    least[k] = reduced;
                    before[k] = place;
                }
                if (least[k] < step) {
                    step = least[k];
                    nearest = k;
                }
            }
            for (std::size_t k = 0; k < m_agentAt.size(); ++k)
                if (done[k]) {
                    m_agentMultiplier[at(m_agentAt[k])] += step;
                    m_placeMultiplier[k] -= step;
                } else {
                    least[k] -= step;
                }
            place = nearest;
        }
        for (; place != 0; place = before[place])
            m_agentAt[place] = m_agentAt[before[place]];
        return true;
    }

    [[nodiscard]] std::vector<int> places() const
    {
        std::vector<int> places(at(m_cost.cols()), 0);
        for (std::size_t k = 1; k < m_agentAt.size(); ++k)
            if (m_agentAt[k] != 0)
                places[at(m_agentAt[k]) - 1] = static_cast<int>(k) - 1;
        return places;
    }

private:
    [[nodiscard]] static std::size_t at(Eigen::Index k) { return static_cast<std::size_t>(k); }

    const Eigen::MatrixXd& m_cost;
    const std::function<bool()>& m_isStopped;
    std::vector<double> m_agentMultiplier;
    std::vector<double> m_placeMultiplier;
    std::vector<Eigen::Index> m_agentAt; ///< by place
};

} // namespace

std::vector<int> cheapestAssignment(const Eigen::MatrixXd& cost,
                                    const std::function<bool()>& isStopped)
{
    require(cost.cols() <= cost.rows() && cost.allFinite(),
            "cheapestAssignment: needs finite costs and a place for each column");
    AssignmentSearch assignment(cost, isStopped);
    for (Eigen::Index agent = 1; agent <= cost.cols(); ++agent)
        if (!assignment.add(agent))
            return {};
    return assignment.places();
}

} // namespace berg
