#include "app/dialogs/wind_dialog.h"

#include "core/scenario/limits.h"
#include "widgets/document/wind.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/theme/quantity_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kWholeCircle_deg = 360;
constexpr double kStep_deg = 5;
constexpr double kStep = 0.5;    // m/s or knots
constexpr double kFinest = 0.01; // of what can be typed

} // namespace

WindDialog::WindDialog(const Point& wind_mps, double airspeed_mps, QWidget* parent)
    : QDialog(parent), m_wind_mps(wind_mps), m_airspeed_mps(airspeed_mps)
{
    setWindowTitle(tr("Wind"));
    const ShownUnit unit = speedUnit();
    m_speed = new NumberField;
    m_speed->setObjectName(u"windSpeed"_s);
    m_speed->setNumberFormat({.least = 0, .most = 2}, u' ' + unit.name);
    m_speed->limit(0, unit.fromSi(fastestWind_mps(airspeed_mps, unit.toSi(kFinest))));
    m_speed->setSingleStep(kStep);
    m_from = new NumberField;
    m_from->setObjectName(u"windFrom"_s);
    m_from->setNumberFormat({.least = 0, .most = 1}, u"°"_s);
    m_from->limit(0, kWholeCircle_deg);
    m_from->setSingleStep(kStep_deg);
    m_from->setWrapping(true);
    m_note = new QLabel;
    m_note->setObjectName(u"windNote"_s);
    m_note->setWordWrap(true);
    m_note->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_note->setMinimumHeight(2 * m_note->fontMetrics().lineSpacing());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* set = buttons->addButton(tr("&Set"), QDialogButtonBox::AcceptRole);
    set->setObjectName(u"setWindButton"_s);

    auto* form = new QFormLayout(this);
    addNumberRow(*form, tr("S&peed"), m_speed);
    addNumberRow(*form, tr("Blows &from"), m_from);
    form->addRow(m_note);
    form->addRow(buttons);
    set->setDefault(true);

    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_speed, &NumberField::edited, this, &WindDialog::edit);
    connect(m_from, &NumberField::edited, this, &WindDialog::edit);
    m_speed->showValue(unit.fromSi(wind_mps.norm()));
    m_from->showValue(windFrom_deg(wind_mps));
    judge();
    m_speed->selectAll();
    m_speed->setFocus();
}

void WindDialog::edit()
{
    m_wind_mps = windOf(speedUnit().toSi(m_speed->value()), m_from->value());
    judge();
}

void WindDialog::judge()
{
    const bool isStrong = m_wind_mps.norm() >= kStrongWindShare * m_airspeed_mps;
    QString airspeed = speedText(m_airspeed_mps, locale());
    airspeed.replace(u'/', u"/\u2060"_s); // no line ends within the unit
    m_note->setText(isStrong ? tr("The UAV will make little headway in this wind.")
                             : tr("Must be below the UAV's airspeed (%1).").arg(airspeed));
}

} // namespace berg
