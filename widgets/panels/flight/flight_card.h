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

/** Results of a run. */
struct FlightSummary
{
    double zeta_m2s = 0;
    /** Predicted before take-off; nullopt if unknown or for another flight. */
    std::optional<ZetaPrediction> predicted;
    std::optional<double> bound_m2s; ///< lower bound on zeta of any flight
    /** Share of the work for the bound that is done; below 1 it may still rise. */
    double boundShare = 1;
    /** Source of the complete bound, see `BoundPoint`; nullopt while it is computed. */
    std::optional<bool> isBoundFromRates;
    int visits = 0;
    /** Whether the flight was changed, so that the prediction does not apply. */
    bool wasChanged = false;
    QString longestUnseen; ///< iceberg that was out of view longest; may be empty
    double longestUnseen_s = 0;
};

/**
 * Returns the results at the end of a run. `predicted` is the prediction before take-off. Cost:
 * linear in the record.
 */
[[nodiscard]] FlightSummary flightSummary(const FlightRecord& record,
                                          const std::optional<ZetaPrediction>& predicted);

/**
 * A card at the lower right of the map with the results of a run and the next actions. It can be
 * dragged and is hidden until it shows a summary.
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
    [[nodiscard]] static QString boundToolTip(const FlightSummary& summary);
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
    QPoint m_grabbed;                   ///< position of the pointer on the card while it is dragged
    std::optional<QPoint> m_movedTo_px; ///< position chosen by the user; nullopt for the corner
};

} // namespace berg
