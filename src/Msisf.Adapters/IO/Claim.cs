namespace Msisf.Adapters.IO;

/// <summary>A claim that was granted by a <see cref="ClaimFile"/>; disposing of it gives it back.</summary>
public sealed class Claim : IDisposable
{
    private Action? _giveBack;

    internal Claim(Action giveBack, bool isExclusive)
    {
        _giveBack = giveBack;
        IsExclusive = isExclusive;
    }

    /// <summary>Whether the file system keeps other processes from the same claim; false where it knows no locks.</summary>
    public bool IsExclusive { get; }

    /// <inheritdoc/>
    public void Dispose() => Interlocked.Exchange(ref _giveBack, null)?.Invoke();
}
