using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Terrain.Pds;

/// <summary>Checks that the labels of one product's files say the same.</summary>
/// <param name="file">What each file is, e.g. "part".</param>
/// <param name="whole">What they make up, e.g. "model".</param>
internal sealed class PdsAgreement(string file, string whole)
{
    /// <summary>Requires that a keyword has the same value in two labels.</summary>
    /// <param name="keyword">The keyword.</param>
    /// <param name="first">Path of the first label, and its value.</param>
    /// <param name="other">Path of another label, and its value.</param>
    /// <exception cref="BadInputException">The values differ.</exception>
    public void Require<T>(string keyword, (string Path, T Value) first, (string Path, T Value) other)
        where T : notnull
    {
        if (!first.Value.Equals(other.Value))
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{other.Path}: {keyword} is {other.Value}, but {first.Value} in {first.Path}, another {file} of the same {whole}. "
                    + $"Get all {file}s of one release."));
        }
    }
}
