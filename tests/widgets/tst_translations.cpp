#include "widgets/words/policy_words.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>
#include <QtTest>

#include <algorithm>
#include <set>
#include <vector>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

struct Message
{
    QString context;
    QString source;
    QString comment;
    QStringList forms; ///< one, or singular and plural
    QString type;      ///< "unfinished", "vanished", "obsolete" or empty

    [[nodiscard]] QString key() const { return context + u'|' + source + u'|' + comment; }
};

/** They end with what a library says, which is English: it is left out. */
const QStringList kParsersWords = {u"line %1, column %2: %3"_s, u"line %1: %2"_s};

const QString kTranslations = QStringLiteral(BERG_SOURCE_DIR "/translations");

/** Texts that are the same in both languages: symbols of units, names of quantities. */
const std::set<QString> kSame = {u"%1 m"_s,
                                 u"PNR"_s,
                                 u"Landing"_s,
                                 u"Drift"_s,
                                 u"Reserve"_s,
                                 u"%1 km"_s,
                                 u"CZML (Cesium)"_s,
                                 u"%1 m²"_s,
                                 u"%1 min"_s,
                                 u"%1 s"_s,
                                 u"%1 nmi"_s,
                                 u"%1 N"_s,
                                 u"%1 S"_s,
                                 u"N"_s,
                                 u"Zeta ζ"_s,
                                 u"1 UAV"_s,
                                 u"Start %1 %2 UTC"_s,
                                 u"%1 (%2): %3"_s,
                                 u"σ, m²"_s,
                                 u"Zeta ζ, m² s"_s,
                                 u"Zeta %1 m² s"_s,
                                 u"Start %1 UTC"_s,
                                 u"Bergwatch"_s,
                                 u"COIN-OR CBC"_s,
                                 u"UAV"_s,
                                 u"&UAV"_s,
                                 u"CPA, %1"_s,
                                 u"TCPA"_s,
                                 u"TCPA, s"_s,
                                 u"Esc"_s,
                                 u"Id"_s,
                                 u"&Format"_s,
                                 u"q, m²/s"_s,
                                 u"KML (Google Earth)"_s,
                                 u"GeoJSON (QGIS)"_s,
                                 u"Canadian Ice Service (CSV)"_s,
                                 u"International Ice Patrol (CSV)"_s,
                                 u"US National Ice Center (CSV)"_s,
                                 u"%1 ms"_s,
                                 u"%1×"_s,
                                 u"%1 µs"_s,
                                 u"%1 m²/m"_s,
                                 u"%1 m/s"_s,
                                 u"τ"_s,
                                 u"ζ, m² s"_s,
                                 u"B − A"_s,
                                 u"B"_s,
                                 u"A"_s,
                                 u"m"_s,
                                 u"°/s"_s,
                                 u"km"_s,
                                 u"km²"_s,
                                 u"nmi"_s,
                                 u"nmi²"_s,
                                 u"kn"_s,
                                 u"m/s"_s,
                                 u"m² s"_s,
                                 u"m²"_s,
                                 u"%1 %"_s,
                                 u"ζ %1 m² s"_s,
                                 u"%1 m² s"_s,
                                 u"%1 %…"_s,
                                 u"%1: %2"_s,
                                 u"%1 – %2"_s,
                                 u"Median ζ"_s,
                                 u"τ %1"_s};

/** The text of a `translation` element, or of each `numerusform` in it. */
QStringList formsOf(QXmlStreamReader& xml)
{
    QString text;
    QStringList forms;
    while (!xml.atEnd() && xml.readNext() != QXmlStreamReader::EndElement) {
        if (xml.isStartElement())
            forms << xml.readElementText();
        else
            text += xml.text();
    }
    return forms.isEmpty() ? QStringList{text} : forms;
}

std::vector<Message> messagesOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    std::vector<Message> messages;
    QString context;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"name"_s)
            context = xml.readElementText();
        else if (xml.name() == u"message"_s)
            messages.push_back({.context = context});
        else if (xml.name() == u"source"_s)
            messages.back().source = xml.readElementText();
        else if (xml.name() == u"comment"_s)
            messages.back().comment = xml.readElementText();
        else if (xml.name() == u"translation"_s) {
            messages.back().type = xml.attributes().value(u"type"_s).toString();
            messages.back().forms = formsOf(xml);
        }
    }
    return xml.hasError() ? std::vector<Message>() : messages;
}

std::set<QString> keysOf(const std::vector<Message>& messages)
{
    std::set<QString> keys;
    for (const Message& message : messages)
        keys.insert(message.key());
    return keys;
}

/** %1, %2, ... in the text. */
std::set<QString> placeholders(const QString& text)
{
    static const QRegularExpression pattern(u"%[0-9n]"_s);
    std::set<QString> found;
    auto matches = pattern.globalMatch(text);
    while (matches.hasNext())
        found.insert(matches.next().captured());
    return found;
}

QString firstDifference(const std::set<QString>& a, const std::set<QString>& b)
{
    for (const QString& key : a)
        if (b.count(key) == 0)
            return key;
    return {};
}

} // namespace

class TestTranslations : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_messages = messagesOf(kTranslations + u"/bergwatch_nb.ts"_s);
        QVERIFY(m_messages.size() > 50);
    }

    void everythingIsTranslated()
    {
        for (const Message& message : m_messages) {
            QVERIFY2(message.type.isEmpty(), qPrintable(message.key()));
            for (const QString& form : message.forms)
                QVERIFY2(!form.isEmpty(), qPrintable(message.key()));
        }
    }

    void translationsAreNotCopies()
    {
        for (const Message& message : m_messages) {
            const bool isSame = message.forms.contains(message.source);
            QVERIFY2(isSame == (kSame.count(message.source) == 1), qPrintable(message.key()));
        }
    }

    void placeholdersAreKept()
    {
        for (const Message& message : m_messages)
            for (const QString& form : message.forms)
                QVERIFY2(placeholders(form) == placeholders(message.source) ||
                             kParsersWords.contains(message.source),
                         qPrintable(message.key()));
    }

    /** A text added to the program without a translation, or left behind, is found here. */
    void fileHoldsTheTextsOfTheProgram()
    {
        const QTemporaryDir folder;
        const QString fresh = folder.filePath(u"fresh_nb.ts"_s);
        QProcess lupdate;
        const QString root = QStringLiteral(BERG_SOURCE_DIR);
        lupdate.start(QStringLiteral(BERG_LUPDATE),
                      {u"-no-obsolete"_s, u"-locations"_s, u"none"_s, u"-I"_s, root,
                       root + u"/widgets"_s, root + u"/app"_s, u"-ts"_s, fresh});
        QVERIFY(lupdate.waitForFinished(60000));
        QCOMPARE(lupdate.exitCode(), 0);
        const std::set<QString> needed = keysOf(messagesOf(fresh));
        QVERIFY(needed.size() > 50);
        const std::set<QString> present = keysOf(m_messages);
        QCOMPARE(firstDifference(needed, present), QString()); // run target update_translations
        QCOMPARE(firstDifference(present, needed), QString());
    }

    /** The compiled file is part of the program and answers for every text. */
    void compiledFileAnswers()
    {
        QTranslator translator;
        QVERIFY(translator.load(QLocale(QLocale::NorwegianBokmal), u"bergwatch"_s, u"_"_s,
                                u":/i18n"_s));
        for (const Message& message : m_messages) {
            const QByteArray comment = message.comment.toUtf8();
            for (qsizetype form = 0; form < message.forms.size(); ++form) {
                // Norwegian has a singular, for 1, and a plural.
                const int count = message.forms.size() == 1 ? -1 : static_cast<int>(form) + 1;
                QCOMPARE(translator.translate(message.context.toUtf8().constData(),
                                              message.source.toUtf8().constData(),
                                              comment.isEmpty() ? nullptr : comment.constData(),
                                              count),
                         message.forms[form]);
            }
        }
    }

    void programSpeaksNorwegian()
    {
        const PlannerSettings settings{.policy = PolicyKind::Nearest};
        const QLocale locale(QLocale::NorwegianBokmal, QLocale::Norway);
        QCOMPARE(policyText(settings, locale), u"Nearest iceberg first"_s);
        QTranslator translator;
        QVERIFY(translator.load(locale, u"bergwatch"_s, u"_"_s, u":/i18n"_s));
        QVERIFY(QCoreApplication::installTranslator(&translator));
        QCOMPARE(policyText(settings, locale), u"Nærmeste isfjell først"_s);
        QCOMPARE(policyText({.tau = 1.5}, locale), u"Vektet besøksrekkefølge, avveining τ 1,50"_s);
        QCoreApplication::removeTranslator(&translator);
    }

private:
    std::vector<Message> m_messages;
};

QTEST_MAIN(TestTranslations)
#include "tst_translations.moc"
