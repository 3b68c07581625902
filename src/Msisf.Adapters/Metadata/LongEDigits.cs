namespace Msisf.Adapters.Metadata;

/// <summary>Significant digits of a number in the longE format.</summary>
public enum LongEDigits
{
    /// <summary>16, as thesis section 9.2 has them; some doubles read back to a neighbour.</summary>
    Thesis,

    /// <summary>17: every double reads back as it was.</summary>
    RoundTrip,
}
