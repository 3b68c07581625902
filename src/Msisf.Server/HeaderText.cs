namespace Msisf.Server;

/// <summary>Texts in HTTP headers, which hold printable ASCII only.</summary>
internal static class HeaderText
{
    /// <summary>The text with a question mark for each other character.</summary>
    public static string Of(string text) => string.Concat(text.Select(letter => letter is >= ' ' and <= '~' ? letter : '?'));
}
