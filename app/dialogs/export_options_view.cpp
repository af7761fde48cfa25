#include "app/dialogs/export_options_view.h"

#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr double kMostAltitude_m = 20'000;
constexpr double kMetreStep = 10;
constexpr double kFootStep = 50;
constexpr double kMostSpeed_mps = 500;
constexpr double kMostAcceptance_m = 100'000;

/** 0 stands for nothing entered. */
std::optional<double> valueOf(const NumberField& box)
{
    return box.value() > 0 ? std::optional(box.value()) : std::nullopt;
}

template <class T>
void storeIf(bool holds, T& option)
{
    if (!holds)
        option = T{};
}

void choose(QComboBox& box, const QVariant& data)
{
    box.setCurrentIndex(std::max(0, box.findData(data)));
}

} // namespace

ExportOptionsView::ExportOptionsView(const Scenario& scenario, bool flown,
                                     const ExportOptions& options, QWidget* parent)
    : QWidget(parent), m_isFlown(flown), m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(0, 0, 0, 0);
    addWhat(flown);
    addUavs(scenario);
    addNumbers();
    addReturn();
    fill(options);
    for (QComboBox* box : {m_what, m_uav, m_return}) {
        guardWheel(*box);
        connect(box, &QComboBox::currentIndexChanged, this, &ExportOptionsView::edited);
    }
    connect(m_what, &QComboBox::currentIndexChanged, this, [this] { m_isWhatChosen = true; });
    for (NumberField* box : {m_altitude, m_airspeed, m_acceptance})
        connect(box, &NumberField::edited, this, &ExportOptionsView::edited);
    guardWheel(*m_loiter);
    connect(m_loiter, &QSpinBox::valueChanged, this, &ExportOptionsView::edited);
}

void ExportOptionsView::addWhat(bool flown)
{
    m_what = new QComboBox;
    m_what->setObjectName(u"exportWhat"_s);
    const auto add = [this](const QString& text, ExportScope what) {
        m_what->addItem(text, static_cast<int>(what));
    };
    if (flown)
        add(tr("What was flown"), ExportScope::Track);
    add(tr("The whole order"), ExportScope::Order);
    add(tr("The first leg"), ExportScope::FirstLeg);
    add(tr("The path with turns"), ExportScope::Path);
    m_form->addRow(tr("&What"), m_what);
}

void ExportOptionsView::addUavs(const Scenario& scenario)
{
    m_uav = new QComboBox;
    m_uav->setObjectName(u"exportUav"_s);
    m_uav->addItem(tr("All UAVs"), QString());
    for (const Uav& uav : scenario.uavs)
        m_uav->addItem(QString::fromStdString(uav.name.empty() ? uav.id : uav.name),
                       QString::fromStdString(uav.id));
    m_form->addRow(tr("&UAV"), m_uav);
    m_form->setRowVisible(m_uav, areDistinguished(scenario.uavs));
}

NumberField* ExportOptionsView::addNumber(const QString& label, const QString& name,
                                          const QString& unit, double most)
{
    auto* box = new NumberField;
    box->setObjectName(name);
    box->setRange(0, most);
    box->setNumberFormat({.least = 1, .most = 1}, u' ' + unit);
    box->setLowestText(tr("As in the scenario"));
    addNumberRow(*m_form, label, box);
    return box;
}

void ExportOptionsView::addNumbers()
{
    m_altitude = addNumber(tr("&Altitude"), u"exportAltitude"_s, heightUnit().name,
                           heightUnit().fromSi(kMostAltitude_m));
    m_altitude->setSingleStep(shownUnits().height == HeightUnit::Feet ? kFootStep : kMetreStep);
    m_airspeed = addNumber(tr("Air&speed"), u"exportAirspeed"_s, speedUnit().name,
                           speedUnit().fromSi(kMostSpeed_mps));
    m_acceptance =
        addNumber(tr("A&cceptance radius"), u"exportAcceptance"_s, u"m"_s, kMostAcceptance_m);
    m_acceptance->setSingleStep(10);
    m_loiter = new QSpinBox;
    m_loiter->setObjectName(u"exportLoiter"_s);
    m_loiter->setRange(0, kMostLoiterTurns);
    m_loiter->setSpecialValueText(tr("None: fly over"));
    m_form->addRow(tr("&Loiter turns"), m_loiter);
}

void ExportOptionsView::addReturn()
{
    m_return = new QComboBox;
    m_return->setObjectName(u"exportReturn"_s);
    m_return->addItem(tr("As in the scenario"));
    m_return->addItem(tr("Yes"), true);
    m_return->addItem(tr("No"), false);
    m_form->addRow(tr("&Return home"), m_return);
}

void ExportOptionsView::fill(const ExportOptions& options)
{
    // In flight the order may be what a plan was given by itself.
    m_isWhatChosen = options.what && !(m_isFlown && *options.what == ExportScope::Order);
    if (m_isWhatChosen)
        choose(*m_what, static_cast<int>(*options.what));
    choose(*m_uav, QString::fromStdString(options.uav.value_or("")));
    m_altitude->showValue(heightUnit().fromSi(options.altitude_m.value_or(0)));
    m_airspeed->showValue(speedUnit().fromSi(options.airspeed_mps.value_or(0)));
    m_acceptance->showValue(options.acceptance_m.value_or(0));
    m_loiter->setValue(options.loiterTurns);
    if (options.returnHome)
        choose(*m_return, *options.returnHome);
}

void ExportOptionsView::showFormat(const ExportFormat& format)
{
    if (m_isFlown && !m_isWhatChosen) {
        const QSignalBlocker blocker(m_what);
        // Only content that is flown has acceptance radii.
        choose(*m_what,
               static_cast<int>(format.holds.radii ? ExportScope::Order : ExportScope::Track));
    }
    const bool hasPath = !format.holds.flownOnly;
    for (QWidget* box :
         std::initializer_list<QWidget*>{m_what, m_uav, m_altitude, m_airspeed, m_return})
        box->setEnabled(hasPath);
    m_acceptance->setEnabled(format.holds.radii);
    m_loiter->setEnabled(format.holds.radii);
}

ExportOptions ExportOptionsView::options() const
{
    ExportOptions options{.altitude_m = valueOf(*m_altitude),
                          .airspeed_mps = valueOf(*m_airspeed),
                          .acceptance_m = valueOf(*m_acceptance),
                          .loiterTurns = m_loiter->value()};
    if (const QString uav = m_uav->currentData().toString(); !uav.isEmpty())
        options.uav = uav.toStdString();
    if (m_what->currentIndex() > 0) // the first is what it is without a choice
        options.what = static_cast<ExportScope>(m_what->currentData().toInt());
    if (const QVariant home = m_return->currentData(); home.isValid())
        options.returnHome = home.toBool();
    if (options.altitude_m)
        options.altitude_m = heightUnit().toSi(*options.altitude_m);
    if (options.airspeed_mps)
        options.airspeed_mps = speedUnit().toSi(*options.airspeed_mps);
    storeIf(m_what->isEnabled(), options.what);
    storeIf(m_uav->isEnabled(), options.uav);
    storeIf(m_altitude->isEnabled(), options.altitude_m);
    storeIf(m_airspeed->isEnabled(), options.airspeed_mps);
    storeIf(m_acceptance->isEnabled(), options.acceptance_m);
    storeIf(m_loiter->isEnabled(), options.loiterTurns);
    storeIf(m_return->isEnabled(), options.returnHome);
    return options;
}

} // namespace berg
