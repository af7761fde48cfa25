#include "core/earth/coordinate_reader.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace berg {
namespace {

struct Replacement
{
    std::string_view written;
    std::string_view plain;
};

// A text that begins with another one must precede it.
constexpr std::array kCharacters{
    Replacement{"°", "*"},      Replacement{"º", "*"},      Replacement{"˚", "*"},
    Replacement{"″", "\""},     Replacement{"”", "\""},     Replacement{"“", "\""},
    Replacement{"''", "\""},    Replacement{"′′", "\""},    Replacement{"’’", "\""},
    Replacement{"′", "'"},      Replacement{"’", "'"},      Replacement{"‘", "'"},
    Replacement{"´", "'"},      Replacement{"`", "'"},      Replacement{"−", "-"},
    Replacement{"–", "-"},      Replacement{"\u00a0", " "}, Replacement{"\u2009", " "},
    Replacement{"\u202f", " "}, Replacement{"Ø", "ø"},      Replacement{"\t", " "}};

constexpr std::array kWords{
    Replacement{"north", "N"}, Replacement{"nord", "N"}, Replacement{"n", "N"},
    Replacement{"south", "S"}, Replacement{"sør", "S"},  Replacement{"s", "S"},
    Replacement{"east", "E"},  Replacement{"øst", "E"},  Replacement{"ø", "E"},
    Replacement{"e", "E"},     Replacement{"west", "W"}, Replacement{"vest", "W"},
    Replacement{"w", "W"},     Replacement{"v", "W"},    Replacement{"deg", "*"},
    Replacement{"sud", "S"},   Replacement{"est", "E"},  Replacement{"ouest", "W"},
    Replacement{"d", "*"},     Replacement{"min", "'"},  Replacement{"sec", "\""}};

constexpr std::size_t kLongestNumber = 20;

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool isLetter(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0 ||
           static_cast<unsigned char>(c) >= 0x80;
}

std::string inLowerCase(std::string text)
{
    for (char& c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

enum class TokenKind
{
    Number,
    Mark,
    Sign,
    Letter,
    Separator
};

struct Token
{
    TokenKind kind = TokenKind::Number;
    std::string text;
};

using Tokens = std::vector<Token>;
using TokensOrFault = std::variant<Tokens, CoordinateFault>;

/**
 * Returns true if commas between digits are decimal signs, or a fault if the text allows both
 * readings.
 */
std::variant<bool, CoordinateFault> hasDecimalCommas(const std::string& text)
{
    std::size_t commas = 0;
    bool isAmbiguous = false;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        if (text[i] != ',' || !isDigit(text[i - 1]) || !isDigit(text[i + 1]))
            continue;
        ++commas;
        const std::size_t next = text.find_first_not_of("0123456789", i + 1);
        isAmbiguous = isAmbiguous || (next != std::string::npos && next + 1 < text.size() &&
                                      text[next] == ',' && isDigit(text[next + 1]));
    }
    if (text.find('.') != std::string::npos || commas == 0)
        return false;
    const bool isOneNumber = text.find_first_not_of("0123456789,+-") == std::string::npos &&
                             commas == 1 && text.find_first_of("+-", 1) == std::string::npos;
    if (isAmbiguous || isOneNumber) // "47,48" may be one number or two
        return CoordinateFault::Ambiguous;
    return true;
}

/** Returns true if the hyphen joins numbers of an angle that has letters: 47-03-12N. */
bool isHyphen(const std::string& text, std::size_t at)
{
    return at > 0 && isDigit(text[at - 1]) && text.find_first_of("NSEW") != std::string::npos;
}

TokensOrFault tokensOf(const std::string& text)
{
    const auto commas = hasDecimalCommas(text);
    if (const auto* fault = std::get_if<CoordinateFault>(&commas))
        return *fault;
    const bool decimalCommas = std::get<bool>(commas);
    Tokens tokens;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        const std::string one(1, c);
        if (isDigit(c) || (c == '.' && at + 1 < text.size() && isDigit(text[at + 1]))) {
            std::string number;
            while (at < text.size() && (isDigit(text[at]) || text[at] == '.' ||
                                        (decimalCommas && text[at] == ',' && at + 1 < text.size() &&
                                         isDigit(text[at + 1]))))
                number += text[at] == ',' ? '.' : text[at], ++at;
            if (std::count(number.begin(), number.end(), '.') > 1)
                return CoordinateFault::Unreadable;
            tokens.push_back({TokenKind::Number, number});
            continue;
        }
        ++at;
        if (c == ' ' || c == ':' || (c == '/' && at == text.size()))
            continue;
        if (c == '*' || c == '\'' || c == '"')
            tokens.push_back({TokenKind::Mark, one});
        else if (c == 'N' || c == 'S' || c == 'E' || c == 'W')
            tokens.push_back({TokenKind::Letter, one});
        else if (c == ',' || c == ';')
            tokens.push_back({TokenKind::Separator, one});
        else if ((c == '+' || c == '-') && !isHyphen(text, at - 1))
            tokens.push_back({TokenKind::Sign, one});
        else if (c != '-')
            return CoordinateFault::Unreadable;
    }
    return tokens;
}

std::vector<std::size_t> placesOf(const Tokens& tokens, TokenKind kind, std::string_view text = {})
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < tokens.size(); ++i)
        if (tokens[i].kind == kind && (text.empty() || tokens[i].text == text))
            places.push_back(i);
    return places;
}

/** Returns the index of the token at which the second angle begins. */
std::variant<std::size_t, CoordinateFault> middleOf(const Tokens& tokens)
{
    const std::vector<std::size_t> letters = placesOf(tokens, TokenKind::Letter);
    const std::vector<std::size_t> separators = placesOf(tokens, TokenKind::Separator);
    const std::vector<std::size_t> numbers = placesOf(tokens, TokenKind::Number);
    const std::vector<std::size_t> degrees = placesOf(tokens, TokenKind::Mark, "*");
    const std::vector<std::size_t> signs = placesOf(tokens, TokenKind::Sign);
    if (letters.size() > 2 || separators.size() > 1 || degrees.size() > 2 || numbers.empty())
        return CoordinateFault::Unreadable;
    if (separators.size() == 1)
        return separators.front();
    if (letters.size() == 2)
        return letters.front() == 0 ? letters.back() : letters.front() + 1;
    if (degrees.size() == 2) {
        const auto second = std::find_if(numbers.rbegin(), numbers.rend(),
                                         [&](std::size_t at) { return at < degrees.back(); });
        const std::size_t at = second == numbers.rend() ? 0 : *second;
        return at > 0 && (tokens[at - 1].kind == TokenKind::Sign) ? at - 1 : at;
    }
    if (letters.size() == 1 && letters.front() > 0 && letters.front() + 1 < tokens.size())
        return letters.front() + 1;
    if (!signs.empty() && signs.back() > 0)
        return signs.back();
    if (numbers.size() == 1 || degrees.size() == 1 || letters.size() == 1)
        return CoordinateFault::Half;
    if (numbers.size() % 2 != 0)
        return CoordinateFault::Ambiguous;
    return numbers[numbers.size() / 2];
}

std::variant<CoordinateAngle, CoordinateFault> angleOf(const Tokens& tokens)
{
    constexpr std::string_view kMarks = "*'\"";
    CoordinateAngle angle;
    std::size_t marks = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        switch (token.kind) {
        case TokenKind::Separator:
            break;
        case TokenKind::Number:
            if (token.text.size() > kLongestNumber)
                return CoordinateFault::Unreadable;
            angle.numbers.push_back(token.text);
            break;
        case TokenKind::Sign:
            if (angle.sign || !angle.numbers.empty())
                return CoordinateFault::Unreadable;
            angle.sign = token.text.front();
            break;
        case TokenKind::Letter:
            if (angle.letter || (!angle.numbers.empty() && i + 1 != tokens.size()))
                return CoordinateFault::Unreadable;
            angle.letter = token.text.front();
            break;
        case TokenKind::Mark:
            // A mark belongs to the number before it.
            if (angle.numbers.empty() || angle.numbers.size() <= marks ||
                kMarks.find(token.text.front()) + 1 != angle.numbers.size())
                return CoordinateFault::Unreadable;
            marks = angle.numbers.size();
            break;
        }
    }
    if (angle.numbers.empty())
        return CoordinateFault::Half;
    if (angle.numbers.size() > 3)
        return CoordinateFault::Unreadable;
    return angle;
}

} // namespace

std::string plainCharacters(std::string_view text)
{
    std::string out;
    while (!text.empty()) {
        const auto known =
            std::find_if(kCharacters.begin(), kCharacters.end(),
                         [&](const Replacement& one) { return text.starts_with(one.written); });
        const std::string_view next = known == kCharacters.end() ? text.substr(0, 1) : known->plain;
        if (next != " " || (!out.empty() && out.back() != ' '))
            out += next;
        text.remove_prefix(known == kCharacters.end() ? 1 : known->written.size());
    }
    if (out.ends_with(' '))
        out.pop_back();
    return out;
}

std::string plainDirections(const std::string& text)
{
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        if (!isLetter(text[at])) {
            plain += text[at++];
            continue;
        }
        const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
        const std::string word(begin, std::find_if_not(begin, text.end(), isLetter));
        const auto known = std::find_if(kWords.begin(), kWords.end(), [&](const Replacement& one) {
            return one.written == inLowerCase(word);
        });
        plain += known == kWords.end() ? word : std::string(known->plain);
        at += word.size();
    }
    return plain;
}

std::variant<CoordinateAngles, CoordinateFault> readAngles(const std::string& plain)
{
    const TokensOrFault read = tokensOf(plain);
    if (const auto* fault = std::get_if<CoordinateFault>(&read))
        return *fault;
    const auto& tokens = std::get<Tokens>(read);
    const auto middle = middleOf(tokens);
    if (const auto* fault = std::get_if<CoordinateFault>(&middle))
        return *fault;
    const auto split = tokens.begin() + static_cast<std::ptrdiff_t>(std::get<std::size_t>(middle));
    const auto first = angleOf({tokens.begin(), split});
    const auto second = angleOf({split, tokens.end()});
    for (const auto* angle : {&first, &second})
        if (const auto* fault = std::get_if<CoordinateFault>(angle))
            return *fault;
    return CoordinateAngles{std::get<CoordinateAngle>(first), std::get<CoordinateAngle>(second)};
}

} // namespace berg
