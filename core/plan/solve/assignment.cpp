#include "core/plan/solve/assignment.h"

#include "core/base/error.h"

#include <limits>

namespace berg {

namespace {

/** People and places count from 1; 0 is none. */
class AssignmentSearch
{
public:
    AssignmentSearch(const Eigen::MatrixXd& cost, const std::function<bool()>& cut)
        : m_cost(cost)
        , m_cut(cut)
        , m_ownPrice(at(cost.cols()) + 1, 0.0)
        , m_placePrice(at(cost.rows()) + 1, 0.0)
        , m_whoIsAt(at(cost.rows()) + 1, 0)
    {
    }

    /** Gives someone a place, on the shortest path of exchanges to a free one. False when cut. */
    [[nodiscard]] bool add(Eigen::Index who)
    {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        std::vector<double> least(m_whoIsAt.size(), kInfinity);
        std::vector<std::size_t> before(m_whoIsAt.size(), 0);
        std::vector<bool> done(m_whoIsAt.size(), false);
        m_whoIsAt[0] = who;
        std::size_t place = 0;
        while (m_whoIsAt[place] != 0) {
            if (m_cut && m_cut())
                return false;
            done[place] = true;
            const Eigen::Index from = m_whoIsAt[place];
            const double* const costs = m_cost.col(from - 1).data();
            double step = kInfinity;
            std::size_t nearest = 0;
            for (std::size_t k = 1; k < m_whoIsAt.size(); ++k) {
                if (done[k])
                    continue;
                const double reduced = costs[k - 1] - m_ownPrice[at(from)] - m_placePrice[k];
                if (reduced < least[k]) {
                    least[k] = reduced;
                    before[k] = place;
                }
                if (least[k] < step) {
                    step = least[k];
                    nearest = k;
                }
            }
            for (std::size_t k = 0; k < m_whoIsAt.size(); ++k)
                if (done[k]) {
                    m_ownPrice[at(m_whoIsAt[k])] += step;
                    m_placePrice[k] -= step;
                } else {
                    least[k] -= step;
                }
            place = nearest;
        }
        for (; place != 0; place = before[place])
            m_whoIsAt[place] = m_whoIsAt[before[place]];
        return true;
    }

    [[nodiscard]] std::vector<int> places() const
    {
        std::vector<int> places(at(m_cost.cols()), 0);
        for (std::size_t k = 1; k < m_whoIsAt.size(); ++k)
            if (m_whoIsAt[k] != 0)
                places[at(m_whoIsAt[k]) - 1] = static_cast<int>(k) - 1;
        return places;
    }

private:
    [[nodiscard]] static std::size_t at(Eigen::Index k) { return static_cast<std::size_t>(k); }

    const Eigen::MatrixXd& m_cost;
    const std::function<bool()>& m_cut;
    std::vector<double> m_ownPrice;
    std::vector<double> m_placePrice;
    std::vector<Eigen::Index> m_whoIsAt; ///< by place
};

} // namespace

std::vector<int> cheapestAssignment(const Eigen::MatrixXd& cost, const std::function<bool()>& cut)
{
    require(cost.cols() <= cost.rows() && cost.allFinite(),
            "cheapestAssignment: finite, a place for everyone");
    AssignmentSearch assignment(cost, cut);
    for (Eigen::Index who = 1; who <= cost.cols(); ++who)
        if (!assignment.add(who))
            return {};
    return assignment.places();
}

} // namespace berg
