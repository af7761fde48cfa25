#include "app/dialogs/generate_dialog.h"

#include "core/checks/validate.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/words/field_names.h"
#include "widgets/words/issue_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kLastSeed = 999'999;
constexpr double kLargestSide_m = 1e6;
constexpr double kLargestSigma = 1e6;
constexpr double kLargestGrowth = 1e3;
constexpr double kLargestSpacing_m = 100'000;
constexpr double kWidth_m = 5000; ///< Table 3 of the paper
constexpr double kHeight_m = 4000;

/** Adds a form row: a label, then fields and the words between them side by side. */
void addRow(QFormLayout& form, const QString& text, std::initializer_list<QWidget*> widgets)
{
    auto* row = new QHBoxLayout;
    for (QWidget* widget : widgets) {
        auto* number = qobject_cast<NumberField*>(widget);
        row->addWidget(number != nullptr ? withRemark(number) : widget,
                       qobject_cast<QLabel*>(widget) == nullptr ? 1 : 0);
    }
    auto* label = new QLabel(text);
    label->setBuddy(*widgets.begin());
    form.addRow(label, row);
}

std::vector<Point> cornersOf(const Point& low_m, const Point& high_m)
{
    return {low_m, {high_m.x(), low_m.y()}, high_m, {low_m.x(), high_m.y()}};
}

} // namespace

GenerateDialog::GenerateDialog(const Scenario& scenario, const WorldBounds& view_m, QWidget* parent)
    : QDialog(parent), m_scenario(scenario), m_view_m(view_m), m_result(scenario)
{
    setObjectName(u"generateDialog"_s);
    setWindowTitle(tr("Generate icebergs"));
    auto* column = new QVBoxLayout(this);
    column->setSizeConstraint(QLayout::SetFixedSize);
    auto* form = new QFormLayout;
    column->addLayout(form);
    m_number = new QSpinBox;
    m_number->setObjectName(u"generateNumber"_s);
    m_number->setRange(1, static_cast<int>(kMostIcebergs));
    m_number->setValue(FieldRequest{}.icebergs);
    m_number->selectAll(); // another number can be typed at once
    addRow(*form, tr("&Number"), {m_number});
    connect(m_number, &QSpinBox::valueChanged, this, &GenerateDialog::draw);
    addPlace(*form);
    addMotion(*form);
    addUncertainty(*form);
    addSeed(*form);
    addEnd(*form);
    draw();
}

NumberField* GenerateDialog::makeNumber(const NumberSpec& spec) const
{
    auto* field = new NumberField;
    field->setObjectName(QLatin1String(spec.name));
    field->setAccessibleName(spec.label);
    field->setToolTip(spec.label);
    field->setNumberFormat(spec.decimals, spec.unit);
    field->setRange(0, spec.high);
    field->setSingleStep(spec.step);
    field->showValue(spec.value);
    connect(field, &NumberField::edited, this, &GenerateDialog::draw);
    return field;
}

void GenerateDialog::addPlace(QFormLayout& form)
{
    m_place = new QComboBox;
    m_place->setObjectName(u"generatePlace"_s);
    if (!m_scenario.area_m.empty())
        m_place->addItem(tr("The scenario's area"), static_cast<int>(FieldPlace::Area));
    m_place->addItem(tr("Visible part of the map"), static_cast<int>(FieldPlace::View));
    m_place->addItem(tr("Rectangle in the middle of the map"),
                     static_cast<int>(FieldPlace::Rectangle));
    addRow(form, tr("&Where"), {m_place});
    const auto side = [this, unit = longDistanceUnit()](const char* name, const QString& label,
                                                        double length_m) {
        return makeNumber({name,
                           label,
                           u' ' + unit.name,
                           {0, 2},
                           std::floor(unit.fromSi(kLargestSide_m)),
                           1,
                           unit.fromSi(length_m)});
    };
    m_width = side("generateWidth", tr("Width of the rectangle"), kWidth_m);
    m_height = side("generateHeight", tr("Height of the rectangle"), kHeight_m);
    addRow(form, tr("Si&ze"), {m_width, new QLabel(u"×"_s), m_height});
    connect(m_place, &QComboBox::currentIndexChanged, this, &GenerateDialog::draw);
}

void GenerateDialog::addMotion(QFormLayout& form)
{
    const FieldRequest standard;
    const auto speed = [this, unit = speedUnit()](const char* name, const QString& label,
                                                  double value_mps) {
        return makeNumber({name,
                           label,
                           u' ' + unit.name,
                           {1, 2},
                           shownLimits(limits::kSpeed_mps, unit, 2).high,
                           0.05,
                           unit.fromSi(value_mps)});
    };
    m_speedMin =
        speed("generateSpeedMin", fieldName("generate.speedMin_mps"), standard.speedMin_mps);
    m_speedMax =
        speed("generateSpeedMax", fieldName("generate.speedMax_mps"), standard.speedMax_mps);
    addRow(form, tr("S&peed"), {m_speedMin, new QLabel(tr("to")), m_speedMax});
    m_direction = new QComboBox;
    m_direction->setObjectName(u"generateDirection"_s);
    m_direction->addItem(tr("In any direction"));
    m_direction->addItem(tr("Around one direction"));
    m_direction->addItem(tr("Unknown, changing within 10 h"));
    m_direction->setItemData(2,
                             tr("As fitted to a beacon: 0.15 m/s along each axis, in any "
                                "direction. Icebergs are then measured in flight."),
                             Qt::ToolTipRole);
    addRow(form, tr("D&rift"), {m_direction});
    m_towards_deg = makeNumber(
        {"generateTowards", fieldName("generate.towards_deg"), u"°"_s, {0, 1}, 360, 5, 180});
    m_spread_deg = makeNumber(
        {"generateSpread", fieldName("generate.spread_deg"), u"°"_s, {0, 1}, 180, 5, 30});
    m_towards_deg->setWrapping(true);
    addRow(form, tr("D&irection"), {m_towards_deg, new QLabel(u"±"_s), m_spread_deg});
    connect(m_direction, &QComboBox::currentIndexChanged, this, &GenerateDialog::draw);
}

void GenerateDialog::addUncertainty(QFormLayout& form)
{
    const FieldRequest standard;
    const auto sigma = [this](const char* name, const QString& label, double value_m2) {
        return makeNumber({name, label, u" m²"_s, {0, 3}, kLargestSigma, 1, value_m2});
    };
    m_sigmaMin_m2 =
        sigma("generateSigmaMin", fieldName("generate.sigmaMin_m2"), standard.sigmaMin_m2);
    m_sigmaMax_m2 =
        sigma("generateSigmaMax", fieldName("generate.sigmaMax_m2"), standard.sigmaMax_m2);
    addRow(form, tr("&Uncertainty σ"), {m_sigmaMin_m2, new QLabel(tr("to")), m_sigmaMax_m2});
    m_q_m2ps = makeNumber({"generateGrowth",
                           fieldName("generate.q_m2ps"),
                           u" m²/s"_s,
                           {0, 4},
                           kLargestGrowth,
                           0.005,
                           standard.q_m2ps});
    addRow(form, tr("&Growth q"), {m_q_m2ps});
    const bool isNautical = shownUnits().distance == DistanceUnit::Nautical;
    const ShownUnit spacing = distanceUnit();
    m_spacing = makeNumber({"generateSpacing",
                            fieldName("generate.spacing_m"),
                            u' ' + spacing.name,
                            {0, isNautical ? 3 : 1},
                            std::floor(spacing.fromSi(kLargestSpacing_m)),
                            isNautical ? 0.05 : 50,
                            spacing.fromSi(standard.spacing_m)});
    m_spacing->setLowestText(tr("none"));
    addRow(form, tr("&Minimum spacing"), {m_spacing});
}

void GenerateDialog::addSeed(QFormLayout& form)
{
    m_seed = new QSpinBox;
    m_seed->setObjectName(u"generateSeed"_s);
    m_seed->setRange(0, kLastSeed);
    m_seed->setValue(static_cast<int>(FieldRequest{}.seed));
    m_seed->setToolTip(tr("The same seed generates the same field again."));
    auto* dice = new QPushButton(tr("&Another"));
    dice->setObjectName(u"generateDice"_s);
    dice->setToolTip(tr("Generates another random field."));
    dice->setAutoDefault(false);
    addRow(form, tr("&Seed"), {m_seed, dice});
    connect(m_seed, &QSpinBox::valueChanged, this, &GenerateDialog::draw);
    connect(dice, &QPushButton::clicked, this,
            [this] { m_seed->setValue(QRandomGenerator::global()->bounded(1, kLastSeed)); });
}

void GenerateDialog::addEnd(QFormLayout& form)
{
    m_replace = new QCheckBox(tr("R&eplace existing icebergs"));
    m_replace->setObjectName(u"generateReplace"_s);
    m_replace->setEnabled(!m_scenario.icebergs.empty());
    form.addRow(QString(), m_replace);
    connect(m_replace, &QCheckBox::toggled, this, &GenerateDialog::draw);

    m_state = new QLabel;
    m_state->setObjectName(u"generateState"_s);
    m_state->setWordWrap(true);
    m_state->setMinimumHeight(2 * fontMetrics().lineSpacing()); // the dialog keeps its size
    m_state->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    layout()->addWidget(m_state);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_ok = buttons->addButton(tr("Generate"), QDialogButtonBox::AcceptRole);
    m_ok->setObjectName(u"generateOk"_s);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout()->addWidget(buttons);
    m_ok->setDefault(true); // the dialog knows the button only now
}

GenerateDialog::FieldPlace GenerateDialog::place() const
{
    return static_cast<FieldPlace>(m_place->currentData().toInt());
}

std::vector<Point> GenerateDialog::area_m() const
{
    switch (place()) {
    case FieldPlace::Area:
        return m_scenario.area_m;
    case FieldPlace::View:
        return cornersOf(clampedPosition(m_view_m.min_m), clampedPosition(m_view_m.max_m));
    case FieldPlace::Rectangle:
        break;
    }
    const ShownUnit side = longDistanceUnit();
    const Point half_m = 0.5 * Point(side.toSi(m_width->value()), side.toSi(m_height->value()));
    const Point centre_m = m_view_m.centre_m();
    return cornersOf(clampedPosition(centre_m - half_m), clampedPosition(centre_m + half_m));
}

FieldRequest GenerateDialog::request() const
{
    FieldRequest request{.icebergs = m_number->value(),
                         .area_m = area_m(),
                         .speedMin_mps = speedUnit().toSi(m_speedMin->value()),
                         .speedMax_mps = speedUnit().toSi(m_speedMax->value()),
                         .sigmaMin_m2 = m_sigmaMin_m2->value(),
                         .sigmaMax_m2 = m_sigmaMax_m2->value(),
                         .q_m2ps = m_q_m2ps->value(),
                         .seed = m_seed->value(),
                         .fittedDrift = m_direction->currentIndex() == 2,
                         .spacing_m = distanceUnit().toSi(m_spacing->value())};
    if (m_direction->currentIndex() == 1) {
        request.towards_deg = m_towards_deg->value();
        request.spread_deg = m_spread_deg->value();
    }
    return request;
}

void GenerateDialog::draw()
{
    for (NumberField* field : {m_width, m_height})
        field->setEnabled(place() == FieldPlace::Rectangle);
    for (NumberField* field : {m_towards_deg, m_spread_deg})
        field->setEnabled(m_direction->currentIndex() == 1);
    for (NumberField* field : {m_speedMin, m_speedMax})
        field->setEnabled(m_direction->currentIndex() != 2);
    m_result = m_scenario;
    m_count = 0;
    QString fault;
    try {
        Scenario present = m_scenario;
        if (m_replace->isChecked())
            present.icebergs.clear();
        const std::vector<Iceberg> icebergs = generateIcebergs(present, request());
        present.icebergs.insert(present.icebergs.end(), icebergs.begin(), icebergs.end());
        if (request().fittedDrift) // the simple observer takes velocities as known
            present.observer.model = ObserverModel::Kalman;
        m_result = std::move(present);
        m_count = static_cast<int>(icebergs.size());
    } catch (const Error& error) {
        fault = optionIssueLines(error, "generate").join(u'\n');
    }
    showState(fault);
    emit drawn();
}

void GenerateDialog::showState(const QString& fault)
{
    m_ok->setEnabled(fault.isEmpty());
    const auto all = static_cast<int>(m_result.icebergs.size());
    const QString held = tr("The scenario will have %n icebergs.", nullptr, all);
    m_state->setText(fault.isEmpty() ? held : fault);
}

} // namespace berg
