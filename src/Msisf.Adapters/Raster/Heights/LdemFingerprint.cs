using System.Security.Cryptography;
using Msisf.Adapters.IO;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Tells elevation models apart, in the same way on every computer: hashes of the labels, the lengths of the images, and hashes of samples
/// spread over them. To read a model of 34 GB completely would take longer than to render an image.
/// </summary>
/// <param name="ImageBytes">Length of the image; of a split product all of them.</param>
/// <param name="Sha256">SHA-256 of labels, lengths and pieces of the images: 64 hexadecimal digits.</param>
public sealed record LdemFingerprint(string ProductId, long ImageBytes, string Sha256)
{
    /// <summary>Reads what is needed of several models' files.</summary>
    /// <exception cref="ExternalPartException">They can't be read.</exception>
    public static LdemFingerprint Of(IReadOnlyList<LdemSet> sets)
    {
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        long bytes = 0;
        foreach (LdemLabel label in sets.SelectMany(set => set.Parts))
        {
            FileErrors.ToExternalPart($"{label.LabelPath}: can't be read", () =>
            {
                using Stream text = RasterFiles.OpenRead(label.LabelPath);
                FilePieces.Append(hash, text, 0, Math.Min(text.Length, ModelSource.LongestLabel));
                foreach (string path in (string[])[FileNames.FindIgnoringCase(label.ImagePath) ?? label.ImagePath, .. label.OtherFiles])
                {
                    using Stream image = RasterFiles.OpenRead(path);
                    FilePieces.Append(hash, image);
                    bytes += image.Length;
                }
            });
        }

        return new LdemFingerprint(
            string.Join('+', sets.Select(set => set.ProductId)), bytes, Convert.ToHexStringLower(hash.GetHashAndReset()));
    }
}
