#pragma once

#include "core/base/nice_ticks.h"
#include "widgets/charts/study_picture.h"

namespace berg {

/**
 * zeta against tau, as Figure 4 of the paper: mean with a band between the quartiles, median
 * dashed; of a single case the points alone. The other policies are horizontal lines with their
 * marks right of the largest tau, the shortest path marked TSP as there. Less is better.
 */
class StudyChart : public StudyPicture
{
    Q_OBJECT

public:
    explicit StudyChart(const Theme& theme, QWidget* parent = nullptr);

    [[nodiscard]] QStringList readout(std::size_t setting) const override;
    /** Place of a point of the curve, pixels. */
    [[nodiscard]] QPointF toView(double tau, double zeta_m2s) const;

protected:
    void layOut() override;
    void paintContent(QPainter& painter) const override;

private:
    void fillTitles();
    void setPlot();
    void setTicks();
    void setSpots();
    void placeLabels();
    [[nodiscard]] QString labelOf(const ZetaPoint& policy) const;
    [[nodiscard]] double slot_px(std::size_t policy) const;
    [[nodiscard]] bool hasSpread() const { return m_content.cases > 1; }
    [[nodiscard]] QPolygonF curve(double Summary::*value) const;
    void paintPolicies(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintReference(QPainter& painter) const;

    ZetaContent m_content;
    NiceRange m_axis;
    QRectF m_curveArea; ///< part of the plot that tau spans
    double m_lowTau = 0;
    double m_highTau = 1;
};

} // namespace berg
