#pragma once

#include "core/io/study/study_figures.h"
#include "widgets/charts/figure_view.h"
#include "widgets/study/study_runner.h"

#include <QPixmap>

namespace berg {

/** Mark of a policy on a transparent pixmap, for lists; sharp on high-density screens. */
[[nodiscard]] QPixmap policyPixmap(PolicyKind policy, const Theme& theme, int size_px);

/** The figures of a study on the screen. */
enum class StudyFigureKind
{
    Zeta,       ///< `zetaFigure`
    Differences ///< `differenceFigure`, with as many values of tau as there is room for
};

/** A figure of a study, whose items are the study's settings. */
class StudyChart : public FigureView
{
    Q_OBJECT

public:
    StudyChart(StudyFigureKind kind, const Theme& theme, QWidget* parent = nullptr);

    [[nodiscard]] StudyFigureKind kind() const { return m_kind; }
    /** Sets the result; null if there is none yet. */
    void setResult(const StudyPointer& result);
    [[nodiscard]] QSize sizeHint() const override { return {720, 320}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {360, 190}; }

protected:
    [[nodiscard]] Figure figure() const override;

private:
    [[nodiscard]] Figure figureOf(const StudySummary& summary) const;

    StudyFigureKind m_kind;
    StudyPointer m_result;
};

} // namespace berg
