namespace Msisf.Adapters.Raster.Pds;

/// <summary>Checks that the labels of one product's files say the same.</summary>
internal static class PdsAgreement
{
    /// <summary>Requires that keywords have the same values in all labels.</summary>
    /// <param name="labels">The labels; at least one.</param>
    /// <param name="file">What each file is, e.g. "part".</param>
    /// <param name="whole">What they make up, e.g. "model".</param>
    /// <param name="keywords">The keywords, and the value that a label has for each.</param>
    /// <exception cref="BadInputException">Two values differ.</exception>
    public static void Require<TLabel>(
        IReadOnlyList<TLabel> labels, Func<TLabel, string> pathOf, string file, string whole,
        params IReadOnlyList<(string Keyword, Func<TLabel, object> Of)> keywords)
    {
        TLabel first = labels[0];
        foreach (TLabel other in labels.Skip(1))
        {
            if (keywords.FirstOrDefault(one => !one.Of(first).Equals(one.Of(other))) is { Of: { } of } differing)
            {
                throw new BadInputException(Invariant(
                    $"{pathOf(other)}: {differing.Keyword} is {of(other)}, but {of(first)} in {pathOf(first)}, another {file} of "
                        + $"the same {whole}. Get all {file}s of one release."));
            }
        }
    }
}
