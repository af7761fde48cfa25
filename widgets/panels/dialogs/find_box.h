#pragma once

#include "widgets/model/find_matches.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QToolButton;

namespace berg {

/**
 * One line over the map that finds icebergs, UAVs, places, coordinates and commands, with a list
 * of what it finds. A place beyond what the scenario reaches is not gone to; the box then offers to
 * move the scenario there. Keeps to the middle of the upper edge of its parent. GUI thread.
 */
class FindBox : public QWidget
{
    Q_OBJECT

public:
    /** What the box is opened for. */
    struct Request
    {
        std::vector<FindItem> items;
        LatLon origin;          ///< of the scenario
        bool mayMove = true;    ///< the scenario; not in flight
        bool asksWhere = false; ///< of a new scenario: whatever is chosen is where it is
    };

    explicit FindBox(QWidget* parent);

    void setTheme(const Theme& theme);
    void open(Request request);
    /** Nothing is chosen. */
    void dismiss();

signals:
    /** `name` is empty for a coordinate. */
    void placeChosen(const berg::LatLon& place, const QString& name);
    /** An iceberg or UAV. */
    void objectChosen(const std::string& id);
    void commandChosen(const QString& name);
    /** The scenario is wanted there. */
    void moveRequested(const berg::LatLon& place);
    /** A new scenario is wanted there. */
    void newRequested(const berg::LatLon& place);
    /** Where the new scenario is. */
    void whereChosen(const berg::LatLon& place);
    void favouriteChanged(const QString& key, bool isFavourite);
    void closed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addRows();
    void showMatches();
    void showCurrent();
    void choose();
    void chooseFarPlace(const FindItem& item);
    void toggleFavourite();
    [[nodiscard]] bool isFavourite(const QString& key) const;
    [[nodiscard]] const FindItem* current() const;
    void explain(const QString& reason);
    void place();

    QLineEdit* m_field = nullptr;
    QToolButton* m_star = nullptr;
    QListWidget* m_list = nullptr;
    QLabel* m_reason = nullptr;
    QPushButton* m_move = nullptr;
    QPushButton* m_new = nullptr;
    Theme m_theme = Theme::light();
    Request m_request;
    std::vector<FindItem> m_found; ///< as listed
};

} // namespace berg
