#include "widgets/words/import_text.h"
#include "widgets/words/issue_text.h"
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

/** Texts that are the same in English and that language: symbols of units, names of quantities. */
std::set<QString> sameTexts(const QString& language)
{
    QFile file(QStringLiteral(BERG_TEST_DATA "/translations/same_%1.txt").arg(language));
    std::set<QString> same;
    if (file.open(QIODevice::ReadOnly))
        for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n'))
            if (!line.isEmpty())
                same.insert(line);
    return same;
}

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

/** Translations of the program's languages except English, the language of the sources. */
const QStringList kLanguages{u"da"_s, u"fr"_s, u"nb"_s};

QString pathOf(const QString& language)
{
    return kTranslations + u"/bergwatch_%1.ts"_s.arg(language);
}

/**
 * The texts that lupdate collects from the sources, as the file of a language without translations.
 */
std::vector<Message> textsOfTheProgram(const QStringList& options)
{
    const QTemporaryDir folder;
    const QString fresh = folder.filePath(u"fresh_nb.ts"_s);
    QProcess lupdate;
    const QString root = QStringLiteral(BERG_SOURCE_DIR);
    lupdate.start(QStringLiteral(BERG_LUPDATE),
                  QStringList{u"-no-obsolete"_s, u"-locations"_s, u"none"_s,
                              u"-tr-function-alias"_s, u"QT_TR_NOOP+=en"_s} +
                      options +
                      QStringList{u"-I"_s, root, root + u"/widgets"_s, root + u"/app"_s,
                                  root + u"/core"_s, u"-ts"_s, fresh});
    if (!lupdate.waitForFinished(60000) || lupdate.exitCode() != 0)
        return {};
    return messagesOf(fresh);
}

class TestTranslations : public QObject
{
    Q_OBJECT

private slots:
    void everythingIsTranslated_data() { languages(); }
    void everythingIsTranslated()
    {
        QFETCH(QString, language);
        const std::vector<Message> messages = messagesOf(pathOf(language));
        QVERIFY(messages.size() > 50);
        for (const Message& message : messages) {
            QVERIFY2(message.type.isEmpty(), qPrintable(message.key()));
            for (const QString& form : message.forms)
                QVERIFY2(!form.isEmpty(), qPrintable(message.key()));
        }
    }

    /** lupdate takes some tr() for one of a class without its namespace: nobody would find that. */
    void contextsHaveTheirNamespace()
    {
        std::set<QString> contexts;
        for (const Message& message : textsOfTheProgram({}))
            contexts.insert(message.context);
        QVERIFY(contexts.contains(u"berg::FindBox"_s));
        for (const QString& context : contexts)
            QVERIFY2(!contexts.contains(u"berg::"_s + context), qPrintable(context));
    }

    void translationsAreNotCopies_data()
    {
        QTest::addColumn<QString>("language");
        for (const QString& language : kLanguages)
            QTest::newRow(qPrintable(language)) << language;
    }
    void translationsAreNotCopies()
    {
        QFETCH(QString, language);
        std::set<QString> same;
        for (const Message& message : messagesOf(pathOf(language)))
            if (message.forms.contains(message.source))
                same.insert(message.source);
        const std::set<QString> known = sameTexts(language);
        QVERIFY(!known.empty());
        QCOMPARE(firstDifference(same, known), QString());
        QCOMPARE(firstDifference(known, same), QString());
    }

    /** A singular form may leave out "%n", as in "Delete iceberg". */
    void placeholdersAreKept_data() { languages(); }
    void placeholdersAreKept()
    {
        QFETCH(QString, language);
        for (const Message& message : messagesOf(pathOf(language)))
            for (const QString& form : message.forms) {
                std::set<QString> needed = placeholders(message.source);
                if (message.forms.size() > 1 && &form == &message.forms.front() &&
                    !form.contains(u"%n"_s))
                    needed.erase(u"%n"_s);
                QVERIFY2(placeholders(form) == needed || kParsersWords.contains(message.source),
                         qPrintable(message.key()));
            }
    }

    /** A text added to the program without a translation, or left behind, is found here. */
    void fileHoldsTheTextsOfTheProgram()
    {
        const std::set<QString> needed = keysOf(textsOfTheProgram({}));
        const std::set<QString> plurals = keysOf(textsOfTheProgram({u"-pluralonly"_s}));
        QVERIFY(plurals.size() > 50);
        QVERIFY(needed.size() > plurals.size());
        for (const QString& language : kLanguages + QStringList{u"en"_s}) {
            const std::set<QString> present = keysOf(messagesOf(pathOf(language)));
            const std::set<QString>& wanted = language == u"en"_s ? plurals : needed;
            // run target update_translations
            QCOMPARE(language + firstDifference(wanted, present), language);
            QCOMPARE(language + firstDifference(present, wanted), language);
        }
    }

    /** The compiled file is part of the program and answers for every text. */
    void compiledFileAnswers_data() { languages(); }
    void compiledFileAnswers()
    {
        QFETCH(QString, language);
        QTranslator translator;
        QVERIFY(translator.load(QLocale(language), u"bergwatch"_s, u"_"_s, u":/i18n"_s));
        for (const Message& message : messagesOf(pathOf(language))) {
            const QByteArray comment = message.comment.toUtf8();
            for (qsizetype form = 0; form < message.forms.size(); ++form) {
                // All these languages have a singular, for 1, and a plural.
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

    void oneThingIsSingular()
    {
        QCOMPARE(importSummary({.added = 1, .updated = 2}), u"1 new, 2 updated"_s);
        QCOMPARE(countsText({.errors = 1, .warnings = 2}), u"1 error, 2 warnings"_s);
    }

private:
    static void languages()
    {
        QTest::addColumn<QString>("language");
        for (const QString& language : kLanguages + QStringList{u"en"_s})
            QTest::newRow(qPrintable(language)) << language;
    }
};

QTEST_MAIN(TestTranslations)
#include "tst_translations.moc"
