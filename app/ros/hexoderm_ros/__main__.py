import sys

from hexoderm_ros.main import main

sys.exit(main())
