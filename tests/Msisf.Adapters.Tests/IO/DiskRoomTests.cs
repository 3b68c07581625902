using Msisf.Adapters.IO;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.IO;

public sealed class DiskRoomTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Of_FolderThatIsNotThereYet_IsThatOfTheOneAbove()
    {
        long room = DiskRoom.Of(_folder["new/newer"]);

        // Others write to the disk meanwhile.
        Assert.InRange(room, 1, new DriveInfo(_folder.Path).TotalSize);
        Assert.False(Directory.Exists(_folder["new"]));
    }
}
