#include "app/dialogs/origin_dialog.h"

#include "core/base/error.h"
#include "widgets/map/paint/overview_inset.h"
#include "widgets/panels/fields/place_field.h"
#include "widgets/theme/quantity_text.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kChart_px = 360;
constexpr int kOriginDecimals = 2;
constexpr double kHere_m = 5; ///< more than what the field rounds

} // namespace

OriginDialog::OriginDialog(const Scenario& scenario, const LatLon& suggested, const Theme& theme,
                           QWidget* parent)
    : QDialog(parent), m_scenario(scenario)
{
    setWindowTitle(tr("Move the scenario"));
    m_field = new PlaceField;
    m_field->setObjectName(u"originField"_s);
    auto* caption = new QLabel(tr("&Origin at"));
    caption->setBuddy(m_field);
    m_chart = new OverviewInset;
    m_chart->setObjectName(u"originChart"_s);
    m_chart->setTheme(theme);
    m_chart->setNavigable(true);
    m_chart->setFixedSize(kChart_px, kChart_px);
    m_keepLayout = new QRadioButton(tr("Move &everything along with the origin"));
    m_keepLayout->setObjectName(u"keepLayout"_s);
    m_keepPlaces = new QRadioButton(tr("&Leave everything at its place on the Earth"));
    m_keepPlaces->setObjectName(u"keepPlaces"_s);
    m_keepLayout->setChecked(true);
    m_note = new QLabel;
    m_note->setObjectName(u"originNote"_s);
    m_note->setWordWrap(true);
    m_note->setMinimumHeight(3 * m_note->fontMetrics().lineSpacing());
    m_note->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_move = buttons->addButton(tr("&Move"), QDialogButtonBox::AcceptRole);
    m_move->setObjectName(u"moveButton"_s);

    auto* column = new QVBoxLayout(this);
    column->addWidget(caption);
    column->addWidget(m_field);
    column->addWidget(m_chart, 0, Qt::AlignHCenter);
    column->addWidget(m_keepLayout);
    column->addWidget(m_keepPlaces);
    column->addWidget(m_note);
    column->addWidget(buttons);

    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_field, &QLineEdit::textChanged, this, &OriginDialog::judge);
    connect(m_keepLayout, &QRadioButton::toggled, this, &OriginDialog::judge);
    connect(m_chart, &OverviewInset::placePicked, m_field, &PlaceField::showPlace);
    m_field->showPlace(suggested);
    m_field->selectAll();
    m_move->setDefault(true);
    m_field->setFocus();
}

/** Tries what is asked for: whatever the core refuses is said here and cannot be agreed to. */
void OriginDialog::judge()
{
    m_choice.reset();
    const auto found = m_field->found();
    const auto* place = std::get_if<FoundPlace>(&found);
    if (place != nullptr && path_m(place->at) < kHere_m) {
        m_chart->setPlace(place->at);
        m_note->setText(tr("The origin is here now."));
    } else if (place != nullptr) {
        const MoveMode mode =
            m_keepPlaces->isChecked() ? MoveMode::KeepPlaces : MoveMode::KeepLayout;
        m_chart->setPlace(place->at);
        try {
            [[maybe_unused]] const Scenario moved = movedTo(m_scenario, place->at, mode);
            m_choice = OriginChoice{.origin = place->at, .mode = mode};
            m_note->setText(summary(place->at));
        } catch (const Error&) {
            m_note->setText(tr("Not everything can stay at its place: a scenario reaches %1 from "
                               "its origin. Move everything along, or choose a nearer place.")
                                .arg(distanceText(kLargestCoordinate_m, locale())));
        }
    } else {
        m_note->setText(std::get<QString>(found));
    }
    m_move->setEnabled(m_choice.has_value());
}

QString OriginDialog::summary(const LatLon& place) const
{
    const QString away = distanceText(path_m(place), locale());
    const QString where = placeText(place, kOriginDecimals, locale());
    return m_keepPlaces->isChecked() ? tr("The origin moves to %1, %2 away. Positions, courses and "
                                          "drift on the Earth stay the same.")
                                           .arg(where, away)
                                     : tr("Everything moves to %1, %2 away, and keeps its position "
                                          "relative to the origin.")
                                           .arg(where, away);
}

double OriginDialog::path_m(const LatLon& place) const
{
    return LocalFrame(m_scenario.origin).toPlane(place).norm();
}

} // namespace berg
