namespace Msisf.Stress.Fuzz;

/// <summary>Pieces of text that readers trip over.</summary>
internal static class FuzzWords
{
    /// <summary>Numbers at and beyond every border, and what looks like one.</summary>
    public static IReadOnlyList<string> Numbers { get; } =
    [
        "0", "-0", "1", "-1", "2", "7", "0.5", "-1e-300", "1e-400", "5e-324", "1e9", "-1e9", "1e38", "1e308", "1e309", "-1e309", "1e99999",
        "NaN", "nan", "Infinity", "-inf", "0x10",
        "255", "256", "32767", "32768", "65535", "65536", "2147483647", "2147483648", "-2147483648", "4294967296", "9223372036854775807",
        "9223372036854775808",
        "18446744073709551616", "99999999999999999999999999", "1,5", "1.5.5", "1e", "e1", "+", "-", ".", "--5", "+-5", "1_000", "\u0661",
        "\u22125", "1\u00A0000", "1d3", "16#FF#",
    ];

    /// <summary>Signs that mean something to one of the formats.</summary>
    public static IReadOnlyList<string> Signs { get; } =
    [
        "{", "}", "[", "]", "(", ")", "<", ">", ":", ",", ";", "=", "#", "\"", "'", "\\", "/*", "*/", "&a", "*a", "!!", "|", "-", "---",
        "...", "@", "~", "%", "$",
        "\t", "\r", "\n", "\r\n", "\0", "\u001A", "\u007F", "\u0085", "\u2028", "\uFEFF", "\uFFFD", "\u00E4", "\U0001F311", "\u202E",
        "^IMAGE = ", "END\n", "OBJECT = X\n", "\\begindata\n", "\\begintext\n", "{step:", "{mjd:", "{step:P9}", "null", "true", "{}", "[]",
        "\"\":",
    ];
}
