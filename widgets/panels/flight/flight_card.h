#pragma once

#include "core/study/zeta_prediction.h"
#include "widgets/theme/theme.h"

#include <QFrame>

class QGridLayout;
class QLabel;
class QToolButton;

namespace berg {

struct FlightRecord;
class FigureLabel;

/** What a run has come to. */
struct FlightSummary
{
    double zeta_m2s = 0;
    std::optional<ZetaPrediction> predicted; ///< before take-off; nullopt: unknown, or of another
    std::optional<double> bound_m2s;         ///< zeta of no flight is below
    double boundShare = 1;                   ///< of the work for it that is done; then it may rise
    int visits = 0;
    bool wasChanged = false; ///< in flight: what was predicted was for another one
    QString longestUnseen;   ///< the iceberg that was out of view longest; empty: none was
    double longestUnseen_s = 0;
};

/** At the end of a run. `predicted`: before take-off. Cost: linear in the record. */
[[nodiscard]] FlightSummary flightSummary(const FlightRecord& record,
                                          const std::optional<ZetaPrediction>& predicted);

/**
 * A card on the map, at its lower right, that tells what a run has come to and offers what one does
 * next. It can be dragged out of the way. Hidden until it is shown a summary.
 */
class FlightCard : public QFrame
{
    Q_OBJECT

public:
    explicit FlightCard(QWidget* map);

    void setTheme(const Theme& theme);
    void showSummary(const FlightSummary& summary);

signals:
    void closed();
    void compareRequested();
    void saveRequested();
    void reportRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    QLabel* addRow(QGridLayout& rows, const QString& name, const QString& caption,
                   const QString& toolTip);
    [[nodiscard]] QString rangeText(const FlightSummary& summary) const;
    void place();

    Theme m_theme = Theme::light();
    QLabel* m_title;
    QToolButton* m_close;
    FigureLabel* m_zeta;
    QLabel* m_predicted;
    QLabel* m_range;
    QLabel* m_bound;
    QLabel* m_visits;
    QLabel* m_unseen;
    QPoint m_grabbed;                   ///< where it is held while it is dragged
    std::optional<QPoint> m_movedTo_px; ///< by the user; none: in its corner
};

} // namespace berg
