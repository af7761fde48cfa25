#include "core/plan/assignment.h"

#include "core/base/error.h"

#include <limits>

namespace berg {

namespace {

/** Rows and columns count from 1; 0 is none. */
class Assignment
{
public:
    explicit Assignment(const Eigen::MatrixXd& cost)
        : m_cost(cost)
        , m_rowPrice(at(cost.rows()) + 1, 0.0)
        , m_columnPrice(at(cost.cols()) + 1, 0.0)
        , m_rowOf(at(cost.cols()) + 1, 0)
    {
    }

    /** Gives the row a column, on the shortest path of exchanges to a free one. */
    void add(Eigen::Index row)
    {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        std::vector<double> least(m_rowOf.size(), kInfinity);
        std::vector<std::size_t> before(m_rowOf.size(), 0);
        std::vector<bool> done(m_rowOf.size(), false);
        m_rowOf[0] = row;
        std::size_t column = 0;
        while (m_rowOf[column] != 0) {
            done[column] = true;
            const Eigen::Index from = m_rowOf[column];
            double step = kInfinity;
            std::size_t nearest = 0;
            for (std::size_t k = 1; k < m_rowOf.size(); ++k) {
                if (done[k])
                    continue;
                const double reduced = m_cost(from - 1, static_cast<Eigen::Index>(k) - 1) -
                                       m_rowPrice[at(from)] - m_columnPrice[k];
                if (reduced < least[k]) {
                    least[k] = reduced;
                    before[k] = column;
                }
                if (least[k] < step) {
                    step = least[k];
                    nearest = k;
                }
            }
            for (std::size_t k = 0; k < m_rowOf.size(); ++k)
                if (done[k]) {
                    m_rowPrice[at(m_rowOf[k])] += step;
                    m_columnPrice[k] -= step;
                } else {
                    least[k] -= step;
                }
            column = nearest;
        }
        for (; column != 0; column = before[column])
            m_rowOf[column] = m_rowOf[before[column]];
    }

    [[nodiscard]] std::vector<int> columns() const
    {
        std::vector<int> columns(at(m_cost.rows()), 0);
        for (std::size_t k = 1; k < m_rowOf.size(); ++k)
            if (m_rowOf[k] != 0)
                columns[at(m_rowOf[k]) - 1] = static_cast<int>(k) - 1;
        return columns;
    }

private:
    [[nodiscard]] static std::size_t at(Eigen::Index k) { return static_cast<std::size_t>(k); }

    const Eigen::MatrixXd& m_cost;
    std::vector<double> m_rowPrice;
    std::vector<double> m_columnPrice;
    std::vector<Eigen::Index> m_rowOf; ///< by column
};

} // namespace

std::vector<int> cheapestAssignment(const Eigen::MatrixXd& cost)
{
    require(cost.rows() <= cost.cols() && cost.allFinite(),
            "cheapestAssignment: finite, no more rows than columns");
    Assignment assignment(cost);
    for (Eigen::Index row = 1; row <= cost.rows(); ++row)
        assignment.add(row);
    return assignment.columns();
}

} // namespace berg
