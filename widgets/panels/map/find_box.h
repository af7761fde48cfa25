#pragma once

#include "widgets/places/find_matches.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QToolButton;

namespace berg {

/**
 * Search box over the map for icebergs, UAVs, places, coordinates, commands and fields of the
 * Inspector, with a list of matches. For a place beyond the reach of the scenario it offers to move
 * the scenario there. Stays at the middle of the upper edge of its parent. GUI thread.
 */
class FindBox : public QWidget
{
    Q_OBJECT

public:
    /** Contents and options of the opened box. */
    struct Request
    {
        std::vector<FindItem> items;
        LatLon origin;          ///< origin of the scenario
        bool mayMove = true;    ///< whether the scenario can be moved; false in flight
        bool asksWhere = false; ///< asks for the place of a new scenario: any choice is that place
    };

    explicit FindBox(QWidget* parent);

    void setTheme(const Theme& theme);
    void open(Request request);
    /** Closes the box without a choice. */
    void dismiss();

signals:
    /** Emitted with an empty `name` for a coordinate. */
    void placeChosen(const berg::LatLon& place, const QString& name);
    /** Emitted with the id of an iceberg or UAV. */
    void objectChosen(const std::string& id);
    void commandChosen(const QString& name);
    /** Emitted with the key of an input of the Inspector. */
    void fieldChosen(const QString& key);
    /** Requests to move the scenario there. */
    void moveRequested(const berg::LatLon& place);
    /** Requests a new scenario there. */
    void newRequested(const berg::LatLon& place);
    /** Emitted with the place of the new scenario. */
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
    std::vector<FindItem> m_found; ///< in the order of the list
};

} // namespace berg
