using System.Security.Cryptography;
using Msisf.Adapters.Raster.Heights;

namespace Msisf.Adapters.Raster.Levels;

/// <summary>
/// SHA-256 of a model's samples: each file's samples are hashed in the file's order, then these hashes in the order of the files.
/// </summary>
internal sealed class LdemContentHash : IDisposable
{
    private readonly IReadOnlyList<LdemPart> _parts;
    private readonly IncrementalHash[] _hashes;

    public LdemContentHash(LdemImage image)
    {
        _parts = image.Parts;
        _hashes = [.. _parts.Select(_ => IncrementalHash.CreateHash(HashAlgorithmName.SHA256))];
    }

    /// <summary>Adds lines of the whole Moon, from north to south, each once.</summary>
    public void Append(int firstLine, int lines)
    {
        for (int index = 0; index < _parts.Count; index++)
        {
            LdemPart part = _parts[index];
            int end = Math.Min(firstLine + lines, part.FirstLine + part.Label.Lines);
            for (int line = Math.Max(firstLine, part.FirstLine); line < end; line++)
            {
                _hashes[index].AppendData(part.LineBytes(line));
            }
        }
    }

    /// <summary>The hash of all that was added.</summary>
    public byte[] Finish() => SHA256.HashData([.. _hashes.SelectMany(hash => hash.GetCurrentHash())]);

    public void Dispose() => Array.ForEach(_hashes, hash => hash.Dispose());
}
